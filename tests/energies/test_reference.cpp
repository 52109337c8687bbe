#include <fstream>

#include "tests/catch.h"
#include "tests/energies/make.h"

using namespace ringlet;
using namespace ringlet::test;

namespace {

struct ReferenceCase {
  std::string energy, kind;
  Points x;
  double stiffness, rest;
  ElementDerivatives expected;

  explicit ReferenceCase(const Json& json)
      : energy(json["energy"]),
        kind(json["kind"]),
        x(3, json["positions"].size()),
        stiffness(json["stiffness"]),
        rest(json["rest"]),
        expected{json["value"], Eigen::VectorXd(x.size()), Eigen::MatrixXd(x.size(), x.size())} {
    for (int v = 0; v < x.cols(); ++v) {
      for (int c = 0; c < 3; ++c) x(c, v) = json["positions"][v][c];
    }
    for (int i = 0; i < x.size(); ++i) {
      expected.gradient(i) = json["gradient"][i];
      for (int j = 0; j < x.size(); ++j) expected.hessian(i, j) = json["hessian"][i][j];
    }
  }
  ElementDerivatives evaluate(const std::string& filter) const {
    const auto made = make_energy({{"type", energy}, {"filter", filter}});
    return made->element_function()->evaluate(x, stiffness, rest);
  }
  /// How much the positions as stored amplify rounding.
  double conditioning() const {
    const double edge =
        (x.rightCols(x.cols() - 1) - x.leftCols(x.cols() - 1)).colwise().norm().minCoeff();
    const double near_singular = kind == "generic" ? 1 : 1e4;
    return near_singular * std::max(1.0, x.colwise().norm().maxCoeff() / edge);
  }
};

}  // namespace

TEST_CASE("elements agree with values computed in 120 digits") {
  std::ifstream file(RINGLET_REFERENCE);
  const Json json = Json::parse(file);
  REQUIRE(json["cases"].size() == 24);
  for (const Json& entry : json["cases"]) {
    const ReferenceCase reference(entry);
    const ElementDerivatives exact = reference.evaluate("exact");
    // k |d angle / dx|, since some cases are at rest.
    const double slope =
        std::sqrt(reference.stiffness * reference.evaluate("gauss_newton").hessian.trace());
    const double rounding = 1e-14 * reference.conditioning();
    INFO(reference.energy << ", " << reference.kind << ", rest " << reference.rest);
    const ElementDerivatives& expected = reference.expected;
    CHECK(std::abs(exact.value - expected.value) <=
          rounding * std::max(expected.value, 1e-3 * reference.stiffness));
    CHECK((exact.gradient - expected.gradient).cwiseAbs().maxCoeff() <= rounding * slope);
    CHECK((exact.hessian - expected.hessian).cwiseAbs().maxCoeff() <=
          1e3 * rounding * expected.hessian.cwiseAbs().maxCoeff());
  }
}
