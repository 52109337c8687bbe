#include <Eigen/Eigenvalues>
#include <algorithm>

#include "tests/catch.h"
#include "tests/energies/probe.h"
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
  std::mt19937 random(5);
  std::vector<double> traces;
  for (int trial = 0; trial < 400; ++trial) {
    const Points rest = random_stencil(random, vertices_of(name), Shape::generic);
    const Points x = random_stencil(random, vertices_of(name), shape, nearly);
    const Eigen::MatrixXd exact = Bound(name, rest, "exact").at(x).hessian;
    const Eigen::MatrixXd tight = Bound(name, rest, "tight").at(x).hessian;
    const double rounding = 1e-11 * std::max(exact.norm(), tight.norm());
    INFO(name << ", shape " << static_cast<int>(shape) << ", trial " << trial);
    REQUIRE(tight.norm() > 0);
    CHECK(smallest_eigenvalue(tight) > -rounding);
    CHECK(smallest_eigenvalue(tight - exact) > -rounding);
    traces.push_back(tight.trace() / trace_of_clamp(exact));
  }
  std::sort(traces.begin(), traces.end());
  return traces;
}

}  // namespace

TEST_CASE("the tight filter is positive semi-definite, majorises the Hessian and is tight") {
  for (const std::string& name : elastic_names) {
    for (const Shape shape : all_shapes) {
      const std::vector<double> traces = check_filter(name, shape, 0.01);
      INFO(name << ", shape " << static_cast<int>(shape));
      CHECK(traces.front() > 1 - 1e-9);
      CHECK(traces[traces.size() / 2] < 1.5);
      CHECK(traces.back() < (shape == Shape::generic ? 1.6 : 2.1));
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
  CHECK(Bound("stretch", rest, "tight").at(x).hessian ==
        Bound("stretch", rest, "exact").at(x).hessian);
}

TEST_CASE("a kernel that gives only its value is filtered by a numeric clamp") {
  std::mt19937 random(17);
  for (const std::string& name : elastic_names) {
    const Points rest = random_stencil(random, vertices_of(name), Shape::generic);
    const Points x = random_stencil(random, vertices_of(name), Shape::generic);
    const Bound exact(make_twin(name, "exact"), {int(rest.cols())}, rest);
    const Bound tight(make_twin(name, "tight"), {int(rest.cols())}, rest);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(exact.at(x).hessian);
    const Eigen::MatrixXd clamped = solver.eigenvectors() *
                                    solver.eigenvalues().cwiseMax(0).asDiagonal() *
                                    solver.eigenvectors().transpose();
    CHECK((tight.at(x).hessian - clamped).norm() < 1e-12 * clamped.norm());
  }
}
