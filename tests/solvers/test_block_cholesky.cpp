// What stands in the diagonal blocks of strands is often graded: a stiff axis beside soft ones, and
// vertices of different mass.

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "solvers/block_cholesky.h"
#include "tests/catch.h"

using namespace ringlet;

namespace {

using Exact = Eigen::Matrix<long double, 3, 3>;

/// D Q diag(1, between, 1 / condition) Q^T D, for a random rotation Q and a D of so many decades.
Eigen::Matrix3d random_matrix(std::mt19937& random, double condition, double decades) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0, 1);
  const Eigen::Matrix3d some =
      Eigen::Matrix3d::NullaryExpr([&](Eigen::Index) { return normal(random); });
  const Eigen::Matrix3d rotation = Eigen::HouseholderQR<Eigen::Matrix3d>(some).householderQ();
  const Eigen::Vector3d values(1, std::pow(condition, -uniform(random)), 1 / condition);
  const Eigen::Vector3d scales = Eigen::Vector3d::NullaryExpr(
      [&](Eigen::Index) { return std::pow(10, decades * (uniform(random) - 0.5)); });
  return scales.asDiagonal() * rotation * values.asDiagonal() * rotation.transpose() *
         scales.asDiagonal();
}

struct Factored {
  explicit Factored(const std::array<Eigen::Matrix3d, lane_count>& matrices) {
    std::array<Pack, 6> triangle;
    for (int lane = 0; lane < lane_count; ++lane) {
      const Eigen::Matrix3d& s = matrices[lane];
      const std::array<double, 6> entries{s(0, 0), s(1, 0), s(1, 1), s(2, 0), s(2, 1), s(2, 2)};
      for (int n = 0; n < 6; ++n) triangle[n][lane] = entries[n];
    }
    inverse = inverse_cholesky(triangle, bad);
  }
  Exact of(int lane) const {
    Exact t = Exact::Zero();
    for (int r = 0, n = 0; r < 3; ++r) {
      for (int c = 0; c <= r; ++c) t(r, c) = inverse.t[n++][lane];
    }
    return t;
  }
  InverseTriangle inverse;
  Mask bad{false};
};

/// The largest entry of T S T^T - I.
double error_of(const Exact& inverse, const Eigen::Matrix3d& matrix) {
  const Exact lower = matrix.cast<long double>().triangularView<Eigen::Lower>();
  const Exact strict = matrix.cast<long double>().triangularView<Eigen::StrictlyLower>();
  const Exact product = inverse * (lower + strict.transpose()) * inverse.transpose();
  return static_cast<double>((product - Exact::Identity()).cwiseAbs().maxCoeff());
}

}  // namespace

TEST_CASE("blocks of any condition and scale are factored to rounding") {
  const double condition = GENERATE(1e0, 1e4, 1e8, 1e12);
  const double decades = GENERATE(0, 10, 30);
  INFO(condition << ", " << decades << " decades");
  std::mt19937 random(7);
  for (int repetition = 0; repetition < 200; ++repetition) {
    std::array<Eigen::Matrix3d, lane_count> matrices;
    for (auto& matrix : matrices) matrix = random_matrix(random, condition, decades);
    const Factored factored(matrices);
    for (int lane = 0; lane < lane_count; ++lane) {
      REQUIRE_FALSE(factored.bad[lane]);
      CHECK(error_of(factored.of(lane), matrices[lane]) < 1e-15 * (5 + condition));
    }
  }
}

TEST_CASE("blocks as small or as large as is promised are factored") {
  for (const double scale : {1e-76, 1e76}) {
    std::mt19937 random(8);
    std::array<Eigen::Matrix3d, lane_count> matrices;
    for (auto& matrix : matrices) matrix = scale * random_matrix(random, 10, 0);
    const Factored factored(matrices);
    for (int lane = 0; lane < lane_count; ++lane) {
      REQUIRE_FALSE(factored.bad[lane]);
      CHECK(error_of(factored.of(lane), matrices[lane]) < 2e-14);
    }
  }
}

TEST_CASE("each lane whose block is not positive definite and finite is told, and no other") {
  const double infinite = std::numeric_limits<double>::infinity();
  const auto with = [](int r, int c, double value) {
    Eigen::Matrix3d matrix = 2 * Eigen::Matrix3d::Identity();
    matrix(r, c) = matrix(c, r) = value;
    return matrix;
  };
  const std::vector<Eigen::Matrix3d> refused{with(0, 0, -1),  with(0, 0, 0),  with(1, 1, -1),
                                             with(2, 2, -1),  with(2, 2, 0),  with(1, 0, 3),
                                             with(2, 0, 3),   with(2, 1, -3), with(0, 0, infinite),
                                             with(2, 1, NAN), with(2, 2, NAN)};
  for (std::size_t n = 0; n < refused.size(); ++n) {
    INFO(n);
    std::array<Eigen::Matrix3d, lane_count> matrices;
    matrices.fill(with(2, 0, 1));
    const int lane = static_cast<int>(n) % lane_count;
    matrices[lane] = refused[n];
    const Factored factored(matrices);
    for (int l = 0; l < lane_count; ++l) CHECK(factored.bad[l] == (l == lane));
  }
}
