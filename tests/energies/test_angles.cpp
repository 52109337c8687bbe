#include <vector>

#include "core/angles.h"
#include "tests/catch.h"

using namespace ringlet;

namespace {

void check_atan2(double y, double x) {
  const Pack angles = atan2(Pack(y), Pack(x));
  const double expected = std::atan2(y, x);
  for (int lane = 0; lane < lane_count; ++lane) {
    INFO("atan2(" << y << ", " << x << ")");
    REQUIRE(std::abs(angles[lane] - expected) <= 4.5e-16 * std::abs(expected));
  }
}

}  // namespace

TEST_CASE("atan2 in lanes is that of the standard library to two units in the last place") {
  for (int i = -3000; i <= 3000; ++i) {
    const double angle = i * (std::numbers::pi / 3000);
    check_atan2(std::sin(angle), std::cos(angle));
  }
  const std::vector<double> values{0,      1e-300, 1e-160, 1e-17, 1e-8,  0.1249999, 0.125,
                                   0.1251, 0.25,   0.375,  0.5,   0.625, 0.875,     0.999999999,
                                   1,      1.5,    3,      1e8,   1e17,  1e160,     1e300};
  for (const double a : values) {
    for (const double b : values) {
      for (const double y : {a, -a}) {
        // Lanes do not tell -0 from +0 in x, as the standard library does.
        for (const double x : {b, b == 0 ? b : -b}) check_atan2(y, x);
      }
    }
  }
}

TEST_CASE("the lanes of atan2 do not see each other") {
  Pack y, x;
  for (int lane = 0; lane < lane_count; ++lane) {
    y[lane] = std::sin(lane - 3.5);
    x[lane] = std::cos(lane - 3.5);
  }
  const Pack angles = atan2(y, x);
  for (int lane = 0; lane < lane_count; ++lane) {
    CHECK(angles[lane] == Approx(std::atan2(y[lane], x[lane])).epsilon(1e-15));
  }
}

TEST_CASE("angles are wrapped to half a turn either way") {
  const double pi = std::numbers::pi;
  for (const double angle : {0.0, 3.0, -3.0, 3.2, -3.2, 6.2, -6.2, 9.4, -9.4}) {
    const double expected = std::remainder(angle, 2 * pi);
    CHECK(wrap_angle(angle) == Approx(expected).margin(1e-15));
    CHECK(wrap_angle(Pack(angle))[lane_count - 1] == Approx(expected).margin(1e-15));
  }
}
