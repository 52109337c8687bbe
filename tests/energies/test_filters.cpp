#include <Eigen/Eigenvalues>
#include <algorithm>

#include "tests/catch.h"
#include "tests/energies/textbook.h"

using namespace ringlet;
using namespace ringlet::test;

namespace {

double trace_of_clamp(const Eigen::MatrixXd& matrix) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .cwiseMax(0)
      .sum();
}

/// Traces of the tight filter relative to those of the numeric clamp, in ascending order.
std::vector<double> check_filter(const std::string& name, Shape shape, double nearly) {
  std::mt19937_64 random(5);
  std::vector<double> traces;
  for (int trial = 0; trial < 400; ++trial) {
    const Points rest = random_strand(random, vertices_of(name), Shape::generic);
    const Points x = random_strand(random, vertices_of(name), shape, nearly);
    const Eigen::MatrixXd exact = bound(name, rest, "exact").at(x).hessian;
    const Eigen::MatrixXd tight = bound(name, rest, "tight").at(x).hessian;
    INFO(name << ", shape " << static_cast<int>(shape) << ", trial " << trial);
    REQUIRE(tight.norm() > 0);
    traces.push_back(tight.trace() / trace_of_clamp(exact));
  }
  std::sort(traces.begin(), traces.end());
  return traces;
}

}  // namespace

TEST_CASE("the tight filter is tight") {
  for (const std::string& name : elastic_names) {
    for (const Shape shape : all_shapes) {
      const std::vector<double> traces = check_filter(name, shape, 0.01);
      INFO(name << ", shape " << static_cast<int>(shape));
      CHECK(traces.front() > 1 - 1e-9);
      CHECK(traces[traces.size() / 2] < 1.5);
      CHECK(traces.back() < (shape == Shape::generic ? 1.6 : 2.3));
    }
  }
}

TEST_CASE("the tight filter of twist is finite where the torsion is 0 or pi") {
  for (const Shape shape : {Shape::nearly_cis, Shape::nearly_trans}) {
    CHECK(check_filter("twist", shape, 1e-12).back() < 2.1);
  }
}

TEST_CASE("a stretched edge needs no filter") {
  Points rest = Points::Zero(3, 2);
  rest(0, 1) = 1;
  const Points x = 1.5 * rest;
  CHECK(bound("stretch", rest, "tight").at(x).hessian ==
        bound("stretch", rest, "exact").at(x).hessian);
}

TEST_CASE("a kernel that gives only its value is clamped where that is asked for") {
  std::mt19937_64 random(17);
  for (const std::string& name : elastic_names) {
    const Points rest = random_strand(random, vertices_of(name), Shape::generic);
    const Points x = random_strand(random, vertices_of(name), Shape::generic);
    const BoundEnergy exact(make_twin(name, "exact"), rest);
    const BoundEnergy clamp(make_twin(name, "clamp"), rest);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(exact.at(x).hessian);
    const Eigen::MatrixXd clamped = solver.eigenvectors() *
                                    solver.eigenvalues().cwiseMax(0).asDiagonal() *
                                    solver.eigenvectors().transpose();
    CHECK((clamp.at(x).hessian - clamped).norm() < 1e-12 * clamped.norm());
  }
}

TEST_CASE("the tight filter of a kernel that gives only its value is a majorant, exact at rest") {
  std::mt19937_64 random(18);
  for (const std::string& name : elastic_names) {
    for (int trial = 0; trial < 20; ++trial) {
      const Points rest = random_strand(random, vertices_of(name), Shape::generic);
      const Points x = random_strand(random, vertices_of(name), Shape::generic);
      const BoundEnergy exact(make_twin(name, "exact"), rest);
      const BoundEnergy tight(make_twin(name, "tight"), rest);
      const Eigen::MatrixXd filtered = tight.at(x).hessian;
      const double scale = filtered.norm();
      INFO(name << ", trial " << trial);
      CHECK(smallest_eigenvalue(filtered / scale) > -1e-13);
      CHECK(smallest_eigenvalue((filtered - exact.at(x).hessian) / scale) > -1e-13);
      const Eigen::MatrixXd at_rest = exact.at(rest).hessian;
      CHECK((tight.at(rest).hessian - at_rest).norm() < 1e-9 * at_rest.norm());
      const Eigen::Matrix3d rotation = random_rotation(random);
      Eigen::MatrixXd turn = Eigen::MatrixXd::Zero(x.size(), x.size());
      for (int v = 0; v < x.cols(); ++v) turn.block<3, 3>(3 * v, 3 * v) = rotation;
      CHECK((tight.at(rotation * x).hessian - turn * filtered * turn.transpose()).norm() <
            1e-10 * scale);
    }
  }
}
