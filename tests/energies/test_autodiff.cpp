#include <cmath>

#include "core/traced.h"
#include "core/verify/probe.h"
#include "tests/catch.h"
#include "tests/energies/dual.h"

using namespace ringlet;

namespace {

constexpr int variables = 3;

/// Uses every function a kernel may call; regular near the points of the tests.
template <class S>
S everything(const S& x, const S& y, const S& z) {
  S sum = sin(x) * cos(y) + tan(z) / (S(2) + x * x);
  sum += exp(x * y) - log(x + 2.0) * sqrt(z);
  sum += pow(z, 1.5) * atan2(y - x, z) + abs(x - y * z);
  sum -= min(x, y) * max(y, z);
  sum *= 0.5 + x;
  sum /= 1.5 - y;
  return select(x < z, sum, S(S(2) * sum)) - (-x) * y;
}

using Number = Dual<double, variables>;

Number at(const std::array<double, 3>& p) {
  return everything(Number::variable(p[0], 0), Number::variable(p[1], 1),
                    Number::variable(p[2], 2));
}
double entry(const Number& a, int i, int j) {
  return i >= j ? a.hessian[i * (i + 1) / 2 + j] : entry(a, j, i);
}

const std::array<double, 3> points[] = {{0.3, -0.2, 0.7}, {-0.4, 0.6, 1.2}, {0.9, 0.1, 0.4}};

}  // namespace

TEST_CASE("dual numbers give the derivatives of what they compute") {
  for (const auto& p : points) {
    const Number result = at(p);
    CHECK(result.value == Approx(everything(p[0], p[1], p[2])).epsilon(1e-14));
    for (int i = 0; i < variables; ++i) {
      auto above = p, below = p;
      above[i] += 1e-5;
      below[i] -= 1e-5;
      const Number high = at(above), low = at(below);
      CHECK(result.gradient[i] == Approx((high.value - low.value) / 2e-5).epsilon(1e-7));
      for (int j = 0; j < variables; ++j) {
        const double difference = (high.gradient[j] - low.gradient[j]) / 2e-5;
        CHECK(entry(result, i, j) == Approx(difference).epsilon(1e-6).margin(1e-6));
      }
    }
  }
}

TEST_CASE("dual numbers over packs are dual numbers in every lane") {
  using Wide = Dual<Pack, variables>;
  std::array<Pack, 3> packs;
  for (int lane = 0; lane < lane_count; ++lane) {
    for (int i = 0; i < 3; ++i) packs[i][lane] = points[lane % 3][i];
  }
  const Wide wide = everything(Wide::variable(packs[0], 0), Wide::variable(packs[1], 1),
                               Wide::variable(packs[2], 2));
  for (int lane = 0; lane < lane_count; ++lane) {
    const Number expected = at(points[lane % 3]);
    CHECK(wide.value[lane] == Approx(expected.value).epsilon(1e-13));
    for (int i = 0; i < variables; ++i) {
      CHECK(wide.gradient[i][lane] == Approx(expected.gradient[i]).epsilon(1e-12));
    }
    for (std::size_t k = 0; k < expected.hessian.size(); ++k) {
      CHECK(wide.hessian[k][lane] == Approx(expected.hessian[k]).epsilon(1e-11).margin(1e-12));
    }
  }
}

TEST_CASE("what has no derivative has the derivative 0") {
  const Number x = Number::variable(0, 0), y = Number::variable(0, 1);
  for (const Number& result : {sqrt(x * x), abs(x), atan2(y, x)}) {
    CHECK(result.value == 0);
    for (const double slope : result.gradient) CHECK(slope == 0);
    for (const double second : result.hessian) CHECK(std::isfinite(second));
  }
}

TEST_CASE("vector functions work on dual numbers") {
  const Vector3<Number> a{Number::variable(1, 0), Number::variable(-2, 1), Number::variable(2, 2)};
  const Number length = norm(a);
  CHECK(length.value == 3);
  CHECK(length.gradient[1] == Approx(-2.0 / 3));
  CHECK(entry(length, 0, 0) == Approx((1 - 1.0 / 9) / 3));
  CHECK(dot(any_normal(a), a).value == Approx(0).margin(1e-15));
}

namespace {

/// Value, gradient and Hessian (lower triangle) by a trace.
template <Curvature curvature, class S, class Function>
Dual<S, variables> by_trace(const std::array<S, variables>& at, const Function& function) {
  Trace<S, variables> trace;
  std::array<Traced<S, variables>, variables> x;
  for (int i = 0; i < variables; ++i) x[i] = {at[i], trace.coordinate_of_sum(1, i), &trace};
  const Traced<S, variables> traced = function(x[0], x[1], x[2]);
  Dual<S, variables> result(traced.value);
  if (traced.is_constant()) return result;
  result.gradient = trace.gradient(traced.node);
  trace.template hessian<curvature>(traced.node)
      .for_each_block([&](int, int, const Matrix3<S>& block) {
        for (int i = 0, k = 0; i < variables; ++i) {
          for (int j = 0; j <= i; ++j, ++k) result.hessian[k] = block(i, j);
        }
      });
  return result;
}

Eigen::Matrix3d hessian(const Number& number) {
  Eigen::Matrix3d result;
  for (int i = 0; i < variables; ++i) {
    for (int j = 0; j < variables; ++j) result(i, j) = entry(number, i, j);
  }
  return result;
}

constexpr auto all_functions = [](const auto& x, const auto& y, const auto& z) {
  return everything(x, y, z);
};
/// More steps than the first page of a trace holds; vectors, some of their components constant.
constexpr auto long_way = [](const auto& x, const auto& y, const auto& z) {
  using S = std::decay_t<decltype(x)>;
  Vector3<S> a{x, y, z}, b{z, S(0.5), x * y}, c{S(1), S(-2), S(0.25)};
  S sum = dot(a, c) + dot(c, c);
  for (int turn = 0; turn < 30; ++turn) {
    const Vector3<S> next = cross(a, b) + S(0.3) * cross(c, a);
    sum += dot(a, next) * inverse_sqrt(S(1) + squared_norm(b)) + norm(a - b);
    a = b;
    b = inverse_sqrt(S(1) + squared_norm(next)) * next;
  }
  return sum;
};

template <class Function>
void compare(const Function& function) {
  for (const auto& p : points) {
    const Number expected =
        function(Number::variable(p[0], 0), Number::variable(p[1], 1), Number::variable(p[2], 2));
    const Number traced = by_trace<Curvature::exact>(p, function);
    CHECK(traced.value == Approx(expected.value).epsilon(1e-14));
    for (int i = 0; i < variables; ++i) {
      CHECK(traced.gradient[i] == Approx(expected.gradient[i]).epsilon(1e-11).margin(1e-12));
    }
    const Eigen::Matrix3d exact = hessian(expected), found = hessian(traced);
    CHECK((found - exact).norm() < 1e-11 * exact.norm());
    const Eigen::Matrix3d positive = hessian(by_trace<Curvature::positive>(p, function));
    REQUIRE(smallest_eigenvalue(exact) < 0);
    CHECK(smallest_eigenvalue(positive) > -1e-12 * positive.norm());
    CHECK(smallest_eigenvalue(positive - exact) > -1e-12 * positive.norm());
  }
}

}  // namespace

TEST_CASE("a trace gives the derivatives that dual numbers give, and a majorant") {
  compare(all_functions);
  compare(long_way);
}

TEST_CASE("a trace over packs is a trace in every lane") {
  std::array<Pack, 3> packs;
  for (int lane = 0; lane < lane_count; ++lane) {
    for (int i = 0; i < 3; ++i) packs[i][lane] = points[lane % 3][i];
  }
  const auto wide = by_trace<Curvature::positive>(packs, all_functions);
  for (int lane = 0; lane < lane_count; ++lane) {
    const Number expected = by_trace<Curvature::positive>(points[lane % 3], all_functions);
    CHECK(wide.value[lane] == Approx(expected.value).epsilon(1e-13));
    for (int i = 0; i < variables; ++i) {
      CHECK(wide.gradient[i][lane] == Approx(expected.gradient[i]).epsilon(1e-12));
    }
    for (std::size_t k = 0; k < expected.hessian.size(); ++k) {
      CHECK(wide.hessian[k][lane] == Approx(expected.hessian[k]).epsilon(1e-9).margin(1e-11));
    }
  }
}

TEST_CASE("what was not chosen does not matter to a trace, even if it is not finite") {
  const auto guarded = [](const auto& x, const auto& y, const auto& z) {
    using S = std::decay_t<decltype(x)>;
    const S infinite = S(1) / (z - z * S(1));
    const Vector3<S> v{x, y, z}, wild = infinite * cross(v, infinite * v);
    const S risky = x * y * infinite * sqrt(y - y) + dot(wild, v);
    return select(x.value > 10, risky, S(x * y));
  };
  const auto [a, b, c] = points[0];
  const Number exact = by_trace<Curvature::exact>(points[0], guarded);
  CHECK(exact.value == Approx(a * b));
  CHECK(exact.gradient == std::array<double, 3>{b, a, 0});
  CHECK((hessian(exact) - Eigen::Matrix3d{{0, 1, 0}, {1, 0, 0}, {0, 0, 0}}).norm() < 1e-14);
  const Number positive = by_trace<Curvature::positive>(points[0], guarded);
  CHECK(hessian(positive).allFinite());
  CHECK(smallest_eigenvalue(hessian(positive)) > -1e-14);
}

TEST_CASE("a trace takes what has no derivative to have the derivative 0") {
  for (const int which : {0, 1, 2}) {
    const Number result =
        by_trace<Curvature::positive>(std::array<double, 3>{0, 0, 0}, [&](auto x, auto y, auto) {
          return which == 0 ? sqrt(x * x) : which == 1 ? abs(x) : atan2(y, x);
        });
    CHECK(result.value == 0);
    for (const double slope : result.gradient) CHECK(slope == 0);
    for (const double second : result.hessian) CHECK(std::isfinite(second));
  }
}
