#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>

#include "core/error.h"
#include "core/random.h"
#include "core/rank_one_update.h"
#include "tests/catch.h"

using namespace ringlet;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Of residuals and angles between eigenvectors; all matrices here have 12 rows or fewer.
constexpr double rounding = 1e-13;

VectorXd random_vector(Random& random, int n) {
  return VectorXd::NullaryExpr(n, [&] { return random.uniform(-1, 1); });
}

Eigensystem random_system(Random& random, const VectorXd& values) {
  const auto n = values.size();
  const MatrixXd matrix = MatrixXd::NullaryExpr(n, n, [&] { return random.uniform(-1, 1); });
  return {values, Eigen::HouseholderQR<MatrixXd>(matrix).householderQ()};
}

/// The update against Eigen's solver, and as an eigensystem of its own.
void check_update(const Eigensystem& system, double rho, const VectorXd& vector) {
  const auto n = system.values.size();
  const MatrixXd& q = system.vectors;
  const MatrixXd matrix =
      q * system.values.asDiagonal() * q.transpose() + rho * (vector * vector.transpose());
  const double size =
      std::max(system.values.cwiseAbs().maxCoeff(), std::abs(rho) * vector.squaredNorm());
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(matrix, Eigen::EigenvaluesOnly);

  const auto [values, vectors] = rank_one_update(system, rho, vector);
  INFO("rho " << rho << "\nvalues " << system.values.transpose() << "\nz "
              << (q.transpose() * vector).transpose());
  REQUIRE(values.size() == n);
  CHECK(std::is_sorted(values.begin(), values.end()));
  CHECK((values - solver.eigenvalues()).norm() <= rounding * size);
  CHECK((matrix * vectors - vectors * values.asDiagonal()).norm() <= rounding * size);
  CHECK((vectors.transpose() * vectors - MatrixXd::Identity(n, n)).norm() <= rounding);
}

/// With both signs of rho, from the negligible to the overwhelming.
void check_updates(const Eigensystem& system, const VectorXd& vector) {
  for (const double size : {1e-20, 1e-15, 1e-8, 0.01, 1.0, 100.0, 1e8, 1e20}) {
    for (const double rho : {size, -size}) check_update(system, rho, vector);
  }
}

}  // namespace

TEST_CASE("a rank-one update has the eigensystem of the updated matrix") {
  Random random(1);
  for (int n = 1; n <= 12; ++n) {
    for (int trial = 0; trial < 20; ++trial) {
      check_updates(random_system(random, random_vector(random, n)), random_vector(random, n));
    }
  }
}

TEST_CASE("a rank-one update of equal and nearly equal eigenvalues keeps its vectors orthogonal") {
  Random random(2);
  for (int n = 2; n <= 12; ++n) {
    for (const double apart : {0.0, 1e-16, 1e-15, 1e-14, 1e-13, 1e-10, 1e-7}) {
      const VectorXd few = (2 * random_vector(random, n)).array().round();
      for (const VectorXd& values : {few, VectorXd(VectorXd::Ones(n))}) {
        const VectorXd clustered = values + apart * random_vector(random, n);
        check_updates(random_system(random, clustered), random_vector(random, n));
      }
    }
  }
}

TEST_CASE("a rank-one update is orthogonal also where the secular equation cancels") {
  // At lambda = 2 the constant and the outer poles sum to zero: the roots beside it are as inexact
  // as that sum is, and so would be eigenvectors taken from them and the given z.
  for (const double beta : {0.1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14}) {
    const Eigensystem system{Eigen::Vector4d(1, 2 - beta, 2 + beta, 10.0 / 3),
                             Eigen::Matrix4d::Identity()};
    check_update(system, 1, Eigen::Vector4d(2, beta, beta, 2));
  }
}

TEST_CASE("a rank-one update leaves alone the eigenvectors that are normal to it") {
  Random random(3);
  for (int n = 1; n <= 12; ++n) {
    const Eigensystem system{random_vector(random, n), MatrixXd::Identity(n, n)};
    for (const double small : {0.0, 1e-300, 1e-18, 1e-12, 1e-6}) {
      VectorXd z = random_vector(random, n);
      for (int i = 0; i < n; i += 2) z(i) *= small;
      check_updates(system, z);
      check_updates(random_system(random, system.values), z);
    }
    const int i = n / 2;
    check_updates(system, VectorXd::Unit(n, i));
    check_update(system, 1, VectorXd::Zero(n));
    check_update(system, 0, random_vector(random, n));
  }
}

TEST_CASE("a rank-one update of the identity and of zero stretches one direction") {
  const Eigen::Vector3d vector(1, 2, 2);
  for (const double value : {0.0, 1.0}) {
    const Eigensystem system{Eigen::Vector3d::Constant(value), Eigen::Matrix3d::Identity()};
    const auto [values, vectors] = rank_one_update(system, 2, vector);
    CHECK((values - Eigen::Vector3d(value, value, value + 18)).norm() < 1e-14);
    CHECK(std::abs(vectors.col(2).dot(vector)) == Approx(3).epsilon(1e-15));
    check_updates(system, vector);
  }
}

TEST_CASE("a rank-one update is exact for eigenvalues far below it, and of any unit") {
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  const Eigen::Vector3d d(1, 2, 3), ones(1, 1, 1);
  // As rho grows, two eigenvalues tend to the zeros of sum 1 / (d_i - lambda): 2 -+ sqrt(1/3).
  const Eigensystem updated = rank_one_update({1e-30 * d, identity}, 1e20, ones);
  CHECK(updated.values(0) == Approx(1e-30 * (2 - std::sqrt(1.0 / 3))).epsilon(1e-14).margin(0));
  CHECK(updated.values(1) == Approx(1e-30 * (2 + std::sqrt(1.0 / 3))).epsilon(1e-14).margin(0));
  CHECK(updated.values(2) == Approx(3e20).epsilon(1e-14));

  const Eigensystem expected = rank_one_update({d, identity}, 1, ones);
  for (const double unit : {1e-300, 1e300}) {
    const Eigensystem same = rank_one_update({unit * d, identity}, unit, ones);
    CHECK((same.values / unit - expected.values).norm() < 1e-14);
    CHECK((same.vectors - expected.vectors).norm() < 1e-14);
  }
}

TEST_CASE("a rank-one update refuses sizes that do not match and what is not finite") {
  const Eigensystem system{Eigen::Vector3d::Ones(), Eigen::Matrix3d::Identity()};
  const Eigen::Vector3d vector(1, 2, 3);
  CHECK_THROWS_WITH(rank_one_update(system, 1, Eigen::Vector2d(1, 2)),
                    "rank-one update: sizes do not match: 3 eigenvalues, 3 x 3 eigenvectors, "
                    "2 numbers in the vector; expected n, n x n, n");
  CHECK_THROWS_AS(rank_one_update({system.values, MatrixXd(3, 2)}, 1, vector), Error);
  CHECK_THROWS_AS(rank_one_update({VectorXd(), MatrixXd()}, 1, VectorXd()), Error);

  CHECK_THROWS_WITH(rank_one_update(system, NAN, vector), contains("must be finite"));
  CHECK_THROWS_AS(rank_one_update(system, 1, INFINITY * vector), Error);
  CHECK_THROWS_AS(rank_one_update({NAN * system.values, system.vectors}, 1, vector), Error);
  CHECK_THROWS_AS(rank_one_update({system.values, NAN * system.vectors}, 1, vector), Error);
  CHECK_THROWS_WITH(rank_one_update(system, 1e300, 1e10 * vector), contains("overflows"));
}
