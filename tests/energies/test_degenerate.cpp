#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "tests/catch.h"
#include "tests/energies/probe.h"
#include "tests/energies/textbook.h"

using namespace ringlet;
using namespace ringlet::test;

namespace {

Points polyline(const std::vector<Eigen::Vector3d>& points) {
  Points x(3, points.size());
  for (std::size_t i = 0; i < points.size(); ++i) x.col(i) = points[i];
  return x;
}

struct NamedShape {
  std::string name;
  Points x;
};

/// Four vertices, of which shorter elements take the first two or three.
std::vector<NamedShape> degenerate_shapes() {
  const Eigen::Vector3d o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), d(0.3, -0.7, 0.55);
  std::vector<NamedShape> shapes{
      {"straight along an axis", polyline({o, x, 2 * x, 3 * x})},
      {"straight askew", polyline({o, d, 2 * d, 3 * d})},
      {"straight, unequal edges", polyline({o, 0.1 * d, 2 * d, 2.3 * d})},
      {"folded", polyline({o, d, o, d})},
      {"folded, unequal edges", polyline({o, d, 0.4 * d, 1.1 * d})},
      {"planar zigzag", polyline({o, x + y, 2 * x, 3 * x + y})},
      {"planar arc", polyline({o, x + y, 2 * x + y, 3 * x})},
      {"first edge parallel", polyline({o, x, 2 * x, 2 * x + y})},
      {"last edge parallel", polyline({y, o, x, 3 * x})},
      {"first edge folded", polyline({1.5 * x, o, x, x + z})},
      {"first edge collapsed", polyline({o, o, x, x + y})},
      {"middle edge collapsed", polyline({y, o, o, x})},
      {"last edge collapsed", polyline({y, o, x, x})},
      {"all at one point", polyline({d, d, d, d})}};
  std::mt19937 random(23);
  const Points generic = random_stencil(random, 4, Shape::generic);
  for (const double scale : {1e-5, 1e-9, 1e-15, 1e-100, 1e-160, 1e-300, 1e6, 1e30}) {
    std::ostringstream name;
    name << "everything times " << scale;
    shapes.push_back({name.str(), scale * generic});
  }
  for (const Shape shape : all_shapes) {
    for (double nearly = 1e-2; nearly > 1e-20; nearly *= 0.1) {
      std::ostringstream name;
      name << "shape " << static_cast<int>(shape) << " to " << nearly;
      shapes.push_back({name.str(), random_stencil(random, 4, shape, nearly)});
    }
  }
  return shapes;
}

bool is_finite(const Probe& probe) {
  return std::isfinite(probe.value) && probe.gradient.allFinite() && probe.hessian.allFinite();
}

}  // namespace

TEST_CASE("value, gradient and Hessian are finite in every state, whatever the rest state") {
  for (const NamedShape& rest : degenerate_shapes()) {
    for (const NamedShape& now : degenerate_shapes()) {
      for (const std::string& name : elastic_names) {
        const int count = vertices_of(name);
        INFO(name << "; rest: " << rest.name << "; now: " << now.name);
        for (const char* filter : {"tight", "exact"}) {
          const Bound energy(name, rest.x.leftCols(count), filter);
          const Probe probe = energy.at(now.x.leftCols(count));
          REQUIRE(is_finite(probe));
          REQUIRE(std::isfinite(energy.value(now.x.leftCols(count))));
          if (std::string(filter) == "tight" && probe.hessian.norm() > 0) {
            const Eigen::MatrixXd scaled = probe.hessian / probe.hessian.cwiseAbs().maxCoeff();
            REQUIRE(smallest_eigenvalue(scaled) > -1e-12);
          }
        }
      }
    }
  }
}

TEST_CASE("a straight strand resists bending in every direction") {
  const Eigen::Vector3d d(0.3, -0.7, 0.55);
  const Points x = polyline({-0.3 * d, d, 3 * d});
  for (const char* filter : {"tight", "exact"}) {
    const Eigen::Matrix3d middle = Bound("bending", x, filter).at(x).hessian.block<3, 3>(3, 3);
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
  std::mt19937 random(1);
  const Points rest = random_stencil(random, 3, Shape::generic);
  const Points straight = polyline({{0, 0, 0}, {1, 1, 0}, {2, 2, 0}});
  const Probe probe = Bound("bending", rest, "tight").at(straight);
  CHECK(probe.gradient.norm() > 0.1 * probe.value);
  CHECK(std::abs(probe.gradient.segment<3>(3).dot(Eigen::Vector3d(1, 1, 0))) <
        1e-12 * probe.gradient.norm());
}

TEST_CASE("twist drives a planar strand out of its plane") {
  std::mt19937 random(2);
  const Points rest = random_stencil(random, 4, Shape::generic);
  for (const Points& planar : {polyline({{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {3, 1, 0}}),
                               polyline({{0, 0, 0}, {1, 1, 0}, {2, 1, 0}, {3, 0, 0}})}) {
    const Probe probe = Bound("twist", rest, "tight").at(planar);
    const Eigen::VectorXd across = probe.gradient.reshaped(3, 4).row(2);
    CHECK(across.norm() == Approx(probe.gradient.norm()));
    CHECK(across.norm() > 0.1 * probe.value);
    CHECK(probe.hessian.norm() > probe.value);
  }
}

TEST_CASE("a collapsed edge is pushed open") {
  const Points rest = polyline({{0, 0, 0}, {0, 2, 0}});
  const Probe probe = Bound("stretch", rest, "tight").at(polyline({{1, 1, 1}, {1, 1, 1}}));
  const double k = double(Textbook("stretch", rest, plain_material()).stiffness);
  CHECK(probe.value == Approx(k / 2));
  CHECK(probe.gradient.head<3>().norm() == Approx(k / 2));
  CHECK(probe.hessian.norm() > 0);
}

TEST_CASE("where twist fades its force is that of its energy") {
  std::mt19937 random(6);
  for (int trial = 0; trial < 100; ++trial) {
    const Points rest = random_stencil(random, 4, Shape::generic);
    Points x =
        random_stencil(random, 4, trial % 2 == 0 ? Shape::straight_end : Shape::generic, 0.3);
    if (trial % 4 == 0) x = Points(x.rowwise().reverse());
    const Bound energy(make_energy({{"type", "twist"}, {"fade", 0.9}}), {4}, rest);
    const Bound unfaded("twist", rest);
    const Probe probe = energy.at(x);
    CHECK(probe.value <= unfaded.value(x) * (1 + 1e-14));
    Eigen::VectorXd differences(12);
    for (int i = 0; i < 12; ++i) {
      Points above = x, below = x;
      above.reshaped()(i) += 1e-6;
      below.reshaped()(i) -= 1e-6;
      differences(i) = (energy.value(above) - energy.value(below)) / 2e-6;
    }
    CHECK((probe.gradient - differences).norm() < 1e-7 * (1 + probe.gradient.norm()));
  }
}

TEST_CASE("twist fades to nothing where an end edge is parallel to the middle one") {
  std::mt19937 random(8);
  const Points rest = random_stencil(random, 4, Shape::generic);
  const Bound energy("twist", rest, "tight");
  double previous = energy.at(random_stencil(random, 4, Shape::straight_end, 1e-5)).value;
  for (double nearly = 1e-6; nearly > 1e-12; nearly *= 0.1) {
    const Probe probe = energy.at(random_stencil(random, 4, Shape::straight_end, nearly));
    CHECK(probe.value < previous);
    previous = probe.value;
  }
  CHECK(previous < 1e-20 * energy.at(random_stencil(random, 4, Shape::generic)).value);
}

TEST_CASE("a strand that is straight at rest has no twist") {
  const Points straight = polyline({{0, 0, 0}, {1, 2, 3}, {2, 4, 6}, {3, 6, 9}});
  std::mt19937 random(9);
  const Points x = random_stencil(random, 4, Shape::generic);
  CHECK(Bound("twist", straight).at(x).value < 1e-20);
}
