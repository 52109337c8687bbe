#include <cmath>

#include "core/dual.h"
#include "core/element.h"
#include "tests/catch.h"

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
