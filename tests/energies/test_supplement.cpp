// The supplement of "Lifted Curls", equation by equation, as math.md (sections 2, 3 and 5) has it.

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "core/angles.h"
#include "core/error.h"
#include "core/verify/differences.h"
#include "energies/angle_eigensystem.h"
#include "energies/twist_jacobians.h"
#include "tests/catch.h"
#include "tests/energies/textbook.h"

using namespace ringlet;
using namespace ringlet::test;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr int trials = 100;
constexpr double rounding = 1e-13;
constexpr double difference_error = 1e-10;

double relative_error(const MatrixXd& a, const MatrixXd& b) { return (a - b).norm() / b.norm(); }

MatrixXd matrix_of(const Eigensystem& system) {
  return system.vectors * system.values.asDiagonal() * system.vectors.transpose();
}

Vector6 stack(const Vector3d& first, const Vector3d& second) {
  Vector6 both;
  both << first, second;
  return both;
}

/// How far the unit vector along q is from an eigenvector with this value.
double residual(const MatrixXd& matrix, double value, const Vector6& q) {
  return (matrix * q - value * q).norm() / q.norm();
}

bool is_orthonormal(const MatrixXd& vectors) {
  const auto n = vectors.cols();
  return (vectors.transpose() * vectors - MatrixXd::Identity(n, n)).norm() < rounding;
}

/// Two unit tangents, neither nearly parallel nor nearly antiparallel.
Points random_tangents(std::mt19937_64& random) {
  const Points x = random_strand(random, 3, Shape::generic);
  Points tangents(3, 2);
  tangents << (x.col(0) - x.col(1)).normalized(), (x.col(2) - x.col(1)).normalized();
  return tangents;
}

AngleFrame frame_of(const Points& edges) { return {edges.col(0), edges.col(1)}; }

/// In [-1.5, 1.5], but not near zero.
double random_factor(std::mt19937_64& random) {
  const double number = random_points(random, 1)(0);
  return number + std::copysign(0.5, number);
}

/// d2Psi/dT2 by the chain rule.
MatrixXd energy_hessian(const AngleFrame& frame, double g, double h) {
  const Vector6 gradient = angle_gradient(frame);
  return h * gradient * gradient.transpose() + g * matrix_of(angle_eigensystem(frame));
}

/// The twist energy of four vertices with respect to w = (u, v).
struct TwistInW {
  Vector6 gradient;
  Vector6 scaling;  ///< the diagonal of S
  Eigensystem eigensystem;
  MatrixXd hessian;

  TwistInW(const Textbook& twist, const FourVertices& x) {
    const Eigen::Matrix3d w = twist_matrix(x);
    const AngleFrame frame(w.col(0), w.col(1));
    const double sign = std::copysign(1.0, w.determinant());
    const double k = static_cast<double>(twist.stiffness);
    const double g = sign * k * wrap_angle(sign * frame.theta - static_cast<double>(twist.rest));
    scaling =
        stack(Vector3d::Constant(1 / w.col(0).norm()), Vector3d::Constant(1 / w.col(1).norm()));
    gradient = g * scaling.asDiagonal() * angle_gradient(frame);
    eigensystem = energy_eigensystem(frame, g, k);
    hessian = scaling.asDiagonal() * matrix_of(eigensystem) * scaling.asDiagonal();
  }

  /// Without its negative eigenvalues, or without the others.
  MatrixXd part(bool positive) const {
    Eigensystem clamped = eigensystem;
    if (positive) clamped.values = clamped.values.cwiseMax(0);
    if (!positive) clamped.values = clamped.values.cwiseMin(0);
    return scaling.asDiagonal() * matrix_of(clamped) * scaling.asDiagonal();
  }
};

struct RandomTwist {
  Points rest, x;
  Textbook textbook;
  TwistInW in_w;
  TwistJacobian exact, simplified, difference;

  explicit RandomTwist(std::mt19937_64& random)
      : rest(random_strand(random, 4, Shape::generic)),
        x(random_strand(random, 4, Shape::generic)),
        textbook("twist", rest, plain_material()),
        in_w(textbook, x),
        exact(exact_twist_jacobian(x)),
        simplified(simplified_twist_jacobian(x)),
        difference(simplified - exact) {}

  /// Whether differences with small steps do not meet the jump of the energy at half a turn.
  bool is_smooth() const {
    const auto turned =
        static_cast<double>(textbook.measure(x.cast<long double>()) - textbook.rest);
    return std::abs(wrap_angle(turned)) < 3;
  }
};

template <class Check>
void for_random_twists(const Check& check) {
  std::mt19937_64 random(11);
  int smooth = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const RandomTwist twist(random);
    if (!twist.is_smooth()) continue;
    ++smooth;
    INFO("trial " << trial);
    check(twist);
  }
  CHECK(smooth > trials / 2);
}

}  // namespace

TEST_CASE("supplement: the derivatives of theta are those of differences") {
  std::mt19937_64 random(1);
  const auto theta = [](const Points& t) {
    return VectorXd::Constant(1, std::acos(t.col(0).normalized().dot(t.col(1).normalized())));
  };
  // Also where the tangents are not of unit length.
  const auto gradient = [](const Points& t) -> VectorXd {
    const AngleFrame frame = frame_of(t);
    return stack(frame.b0 / t.col(0).norm(), -frame.b1 / t.col(1).norm());
  };
  for (int trial = 0; trial < trials; ++trial) {
    const Points t = random_tangents(random);
    const AngleFrame frame = frame_of(t);
    CHECK(frame.theta == Approx(theta(t)(0)).epsilon(rounding));
    CHECK(relative_error(angle_gradient(frame).transpose(), differences(theta, t, 0.01)) <
          difference_error);
    CHECK(relative_error(matrix_of(angle_eigensystem(frame)), differences(gradient, t, 0.01)) <
          difference_error);
  }
}

TEST_CASE("supplement: equations 2 to 7, and the projections onto them") {
  std::mt19937_64 random(2);
  for (int trial = 0; trial < trials; ++trial) {
    const AngleFrame frame = frame_of(random_tangents(random));
    const auto [values, vectors] = angle_eigensystem(frame);
    const double sine = std::sin(frame.theta), cosine = std::cos(frame.theta);
    CHECK(values(0) == Approx((cosine - 1) / sine).epsilon(rounding));
    CHECK(values(1) == Approx((cosine + 1) / sine).epsilon(rounding));
    CHECK(values.sum() == Approx(2 * cosine / sine).epsilon(rounding).margin(rounding));
    CHECK(is_orthonormal(vectors));
    // Section 1.2 prints half the sine, for it takes b for a unit vector.
    const VectorXd halves = vectors.transpose() * angle_gradient(frame).normalized();
    CHECK((halves - 0.5 * stack({0, 0, 1}, {-1, 1, -1})).norm() < rounding);
  }
}

TEST_CASE("supplement: a rank-one update of theta's eigensystem is that of any energy of theta") {
  std::mt19937_64 random(3);
  for (int trial = 0; trial < trials; ++trial) {
    const AngleFrame frame = frame_of(random_tangents(random));
    const double a = random_factor(random), b = random_factor(random);
    for (const auto& [g, h] : {std::pair(a, b), {a, 0.0}, {0.0, b}, {0.0, 0.0}, {1e-9 * a, b}}) {
      INFO("theta " << frame.theta << ", g " << g << ", h " << h);
      Eigensystem scaled = angle_eigensystem(frame);
      scaled.values *= g;
      const Eigensystem updated = rank_one_update(scaled, h, angle_gradient(frame));
      Eigensystem closed_form = energy_eigensystem(frame, g, h);
      CHECK(is_orthonormal(closed_form.vectors));
      const MatrixXd matrix = matrix_of(closed_form);
      CHECK((matrix_of(updated) - matrix).norm() < rounding);
      CHECK((energy_hessian(frame, g, h) - matrix).norm() < rounding);
      std::sort(closed_form.values.begin(), closed_form.values.end());
      CHECK((updated.values - closed_form.values).norm() < rounding);
    }
  }
}

TEST_CASE("supplement: equations 39 and 40 are right as printed") {
  std::mt19937_64 random(4);
  for (int trial = 0; trial < trials; ++trial) {
    const AngleFrame frame = frame_of(random_tangents(random));
    const double g = random_factor(random), h = random_factor(random), r = std::hypot(h, g);
    const MatrixXd hessian = energy_hessian(frame, g, h);
    for (const double value : {h + r, h - r}) {
      const Vector6 printed =
          stack(g * frame.t0 - value * frame.b0, g * frame.t1 + value * frame.b1);
      CHECK(residual(hessian, value, printed) < rounding);
    }
  }
}

TEST_CASE("supplement: equations 6, 7, 27, 28, 32 to 35, 41 and 42 are wrong as printed") {
  std::mt19937_64 random(5);
  for (int trial = 0; trial < trials; ++trial) {
    const AngleFrame frame = frame_of(random_tangents(random));
    const auto& [t0, t1, normal, b0, b1, theta, half_tangent] = frame;
    const Vector3d zero = Vector3d::Zero();
    const MatrixXd theta_hessian = matrix_of(angle_eigensystem(frame));
    const Vector6 q6 = stack(zero, t1 + b1), q7 = stack(zero, t1 - b1);
    CHECK(residual(theta_hessian, -1, q6) == Approx(2));
    CHECK(residual(theta_hessian, 1, q7) == Approx(2));
    CHECK(residual(theta_hessian, 1, q6) < rounding);
    CHECK(residual(theta_hessian, -1, q7) < rounding);

    const double g = random_factor(random);
    const MatrixXd hessian = energy_hessian(frame, g, random_factor(random));
    const Vector6 q41 = stack(t0 + b0, -t1 + b1), q42 = stack(t0 - b0, -t1 - b1);
    CHECK(residual(hessian, g, q41) == Approx(2 * std::abs(g)));
    CHECK(residual(hessian, -g, q42) == Approx(2 * std::abs(g)));
    CHECK(residual(hessian, -g, q41) < rounding);
    CHECK(residual(hessian, g, q42) < rounding);

    const MatrixXd sum = energy_hessian(frame, 1, 1);
    CHECK(residual(sum, 1, stack(t0 - b0, -t1 + b1)) > 1);   // 27
    CHECK(residual(sum, -1, stack(t0 + b0, -t1 - b1)) > 1);  // 28
    CHECK(residual(sum, 1, q41) == Approx(2));               // 34
    CHECK(residual(sum, -1, q42) == Approx(2));              // 35
    const double s = std::pow(std::sin(theta), 2);
    for (const double root : {std::hypot(s, 1.0), -std::hypot(s, 1.0)}) {  // 32, 33
      const double printed = s + root, right = 1 + std::copysign(std::sqrt(2.0), root);
      CHECK(residual(sum, right, stack(t0 - right * b0, t1 + right * b1)) < rounding);
      CHECK(residual(sum, printed, stack(t0 - printed * b0, t1 + printed * b1)) > 0.1 * (1 - s));
    }
  }
}

TEST_CASE("supplement: the angle of parallel edges has no eigensystem") {
  CHECK_THROWS_AS(AngleFrame({1, 2, 2}, {2, 4, 4}), Error);
  CHECK_THROWS_AS(AngleFrame({1, 2, 2}, {-1, -2, -2}), Error);
  CHECK_THROWS_AS(AngleFrame({1, 2, 2}, {0, 0, 0}), Error);
}

TEST_CASE("supplement: the exact dw/dx is that of differences, the simplified one is not") {
  for_random_twists([](const RandomTwist& twist) {
    const auto w = [](const Points& x) -> VectorXd {
      return twist_matrix(x).leftCols<2>().reshaped();
    };
    const MatrixXd measured = differences(w, twist.x, 0.01);
    CHECK(relative_error(twist.exact, measured) < difference_error);
    CHECK(relative_error(twist.simplified, measured) > 0.1);
  });
}

TEST_CASE("supplement: both dw/dx give the gradient of the twist energy") {
  for_random_twists([](const RandomTwist& twist) {
    const VectorXd gradient = twist.exact.transpose() * twist.in_w.gradient;
    CHECK(relative_error(gradient, twist.textbook.gradient(twist.x)) < 1e-7);
    CHECK(relative_error(twist.simplified.transpose() * twist.in_w.gradient, gradient) < rounding);
  });
}

TEST_CASE("supplement: dPsi/dw of section 3 is printed with the wrong sign") {
  for_random_twists([](const RandomTwist& twist) {
    const Eigen::Matrix3d w = twist_matrix(twist.x);
    const Vector3d u = w.col(0), v = w.col(1);
    const auto tau = static_cast<double>(twist.textbook.measure(twist.x.cast<long double>()));
    const double turned = wrap_angle(tau - static_cast<double>(twist.textbook.rest));
    const double factor = std::copysign(1.0, w.determinant()) * turned *
                          static_cast<double>(twist.textbook.stiffness) /
                          (std::abs(std::sin(tau)) * u.norm() * v.norm());
    const Vector6 printed =
        factor * stack(v - v.dot(u) / u.squaredNorm() * u, u - u.dot(v) / v.squaredNorm() * v);
    CHECK(relative_error(-printed, twist.in_w.gradient) < 1e-12);
  });
}

TEST_CASE("supplement: the twist Hessian is J^T H_w J - D^T H_w D") {
  for_random_twists([](const RandomTwist& twist) {
    const auto gradient = [&](const Points& x) -> VectorXd {
      return exact_twist_jacobian(x).transpose() * TwistInW(twist.textbook, x).gradient;
    };
    const auto& [rest, x, textbook, in_w, exact, j, d] = twist;
    const MatrixXd hessian = j.transpose() * in_w.hessian * j - d.transpose() * in_w.hessian * d;
    CHECK(relative_error(hessian, differences(gradient, x, 1e-3)) < difference_error);
    CHECK(relative_error(bound("twist", rest, "exact").at(x).hessian, hessian) < 1e-12);

    const MatrixXd filtered =
        j.transpose() * in_w.part(true) * j - d.transpose() * in_w.part(false) * d;
    CHECK(relative_error(bound("twist", rest, "paper").at(x).hessian, filtered) < 1e-12);
  });
}

TEST_CASE("supplement: only the pairs along the middle edge are met by D") {
  for_random_twists([](const RandomTwist& twist) {
    const MatrixXd met = twist.difference.transpose() * twist.in_w.scaling.asDiagonal() *
                         twist.in_w.eigensystem.vectors;
    CHECK(met.rightCols<4>().norm() < rounding * twist.in_w.scaling.norm() * twist.exact.norm());
    CHECK(met.col(0).norm() > 0.1);
    CHECK(met.col(1).norm() > 0.1);
  });
}
