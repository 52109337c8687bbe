#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "core/verify/differences.h"
#include "tests/catch.h"
#include "tests/energies/textbook.h"

using namespace ringlet;
using namespace ringlet::test;

namespace {

Points polyline(const std::vector<Eigen::Vector3d>& vertices) {
  Points x(3, vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) x.col(i) = vertices[i];
  return x;
}

}  // namespace

TEST_CASE("a straight strand resists bending in every direction") {
  const Eigen::Vector3d d(0.3, -0.7, 0.55);
  const Points x = polyline({-0.3 * d, d, 3 * d});
  for (const char* filter : {"tight", "exact"}) {
    const Eigen::Matrix3d middle = bound("bending", x, filter).at(x).hessian.block<3, 3>(3, 3);
    const Eigen::Vector3d eigenvalues =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(middle).eigenvalues();
    const double k = double(Textbook("bending", x, plain_material()).stiffness);
    const double curvature = (1 / 1.3 + 1 / 2.0) / d.norm();
    CHECK(std::abs(eigenvalues(0)) < 1e-10 * eigenvalues(2));
    CHECK(eigenvalues(1) == Approx(k * curvature * curvature));
    CHECK(eigenvalues(2) == Approx(k * curvature * curvature));
  }
}

TEST_CASE("a strand that is bent at rest is not held by being straight") {
  std::mt19937_64 random(1);
  const Points rest = random_strand(random, 3, Shape::generic);
  const Points straight = polyline({{0, 0, 0}, {1, 1, 0}, {2, 2, 0}});
  const Probe probe = bound("bending", rest, "tight").at(straight);
  CHECK(probe.gradient.norm() > 0.1 * probe.value);
  CHECK(std::abs(probe.gradient.segment<3>(3).dot(Eigen::Vector3d(1, 1, 0))) <
        1e-12 * probe.gradient.norm());
}

TEST_CASE("twist drives a planar strand out of its plane") {
  std::mt19937_64 random(2);
  const Points rest = random_strand(random, 4, Shape::generic);
  for (const Points& planar : {polyline({{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {3, 1, 0}}),
                               polyline({{0, 0, 0}, {1, 1, 0}, {2, 1, 0}, {3, 0, 0}})}) {
    const Probe probe = bound("twist", rest, "tight").at(planar);
    const Eigen::VectorXd across = probe.gradient.reshaped(3, 4).row(2);
    CHECK(across.norm() == Approx(probe.gradient.norm()));
    CHECK(across.norm() > 0.1 * probe.value);
    CHECK(probe.hessian.norm() > probe.value);
  }
}

TEST_CASE("a collapsed edge is pushed open") {
  const Points rest = polyline({{0, 0, 0}, {0, 2, 0}});
  const Probe probe = bound("stretch", rest, "tight").at(polyline({{1, 1, 1}, {1, 1, 1}}));
  const double k = double(Textbook("stretch", rest, plain_material()).stiffness);
  CHECK(probe.value == Approx(k / 2));
  CHECK(probe.gradient.head<3>().norm() == Approx(k / 2));
  CHECK(probe.hessian.norm() > 0);
}

TEST_CASE("where twist fades its force is that of its energy") {
  std::mt19937_64 random(6);
  for (int trial = 0; trial < 100; ++trial) {
    const Points rest = random_strand(random, 4, Shape::generic);
    Points x = random_strand(random, 4, trial % 2 == 0 ? Shape::straight_end : Shape::generic, 0.3);
    if (trial % 4 == 0) x = Points(x.rowwise().reverse());
    const BoundEnergy energy(make_energy({{"type", "twist"}, {"filter", "exact"}, {"fade", 0.9}}),
                             rest);
    const BoundEnergy unfaded = bound("twist", rest);
    const Probe probe = energy.at(x);
    CHECK(probe.value <= unfaded.value(x) * (1 + 1e-14));
    const Eigen::VectorXd gradient =
        differences([&](const Points& p) { return Eigen::VectorXd::Constant(1, energy.value(p)); },
                    x, 1e-2)
            .transpose();
    CHECK((probe.gradient - gradient).norm() < 1e-7 * (1 + probe.gradient.norm()));
  }
}

TEST_CASE("twist fades to nothing where an end edge is parallel to the middle one") {
  std::mt19937_64 random(8);
  const Points rest = random_strand(random, 4, Shape::generic);
  const BoundEnergy energy = bound("twist", rest, "tight");
  double previous = energy.at(random_strand(random, 4, Shape::straight_end, 1e-5)).value;
  for (double nearly = 1e-6; nearly > 1e-12; nearly *= 0.1) {
    const Probe probe = energy.at(random_strand(random, 4, Shape::straight_end, nearly));
    CHECK(probe.value < previous);
    previous = probe.value;
  }
  CHECK(previous < 1e-20 * energy.at(random_strand(random, 4, Shape::generic)).value);
}

TEST_CASE("a strand that is straight at rest has no twist") {
  const Points straight = polyline({{0, 0, 0}, {1, 2, 3}, {2, 4, 6}, {3, 6, 9}});
  std::mt19937_64 random(9);
  const Points x = random_strand(random, 4, Shape::generic);
  CHECK(bound("twist", straight).at(x).value < 1e-20);
}
