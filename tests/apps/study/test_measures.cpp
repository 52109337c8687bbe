#include <cmath>
#include <numbers>

#include "apps/study/curl_shape.h"
#include "apps/study/error_measures.h"
#include "apps/study/resample.h"
#include "core/error.h"
#include "tests/catch.h"

using namespace ringlet;

namespace {

/// turns turns of a helix with so many vertices a turn.
Eigen::Matrix3Xd helix(double radius, double pitch, double per_turn, int vertices) {
  Eigen::Matrix3Xd x(3, vertices);
  for (int i = 0; i < vertices; ++i) {
    const double angle = 2 * std::numbers::pi * i / per_turn;
    x.col(i) << 1 + radius * std::cos(angle), pitch * i / per_turn, radius * std::sin(angle);
  }
  return x;
}

Eigen::Matrix3Xd line(int vertices) {
  Eigen::Matrix3Xd x(3, vertices);
  for (int i = 0; i < vertices; ++i) x.col(i) << 0.1 * i, 0.2 * i, -0.3 * i;
  return x;
}

}  // namespace

TEST_CASE("the radius of a helix is found at any resolution") {
  for (const double per_turn : {2.5, 4.0, 5.0, 17.0, 80.0}) {
    CAPTURE(per_turn);
    const auto radius = curl_radius(helix(0.005, 0.004, per_turn, 60));
    REQUIRE(radius);
    CHECK(*radius == Approx(0.005).epsilon(1e-10));
  }
  CHECK_FALSE(curl_radius(helix(0.005, 0.004, 5, 3)));
  CHECK_FALSE(curl_radius(line(10)));
  CHECK(end_distance(line(11)) == Approx(std::sqrt(14.0)));
}

TEST_CASE("strands are compared at equal fractions, where both have a vertex exactly") {
  const Resampling halved({9, 5}, {5, 3});
  Eigen::Matrix3Xd fine(3, 14);
  for (int i = 0; i < 14; ++i) fine.col(i) << i, 10 * i, std::sin(i);
  const Eigen::Matrix3Xd coarse = halved(fine);
  REQUIRE(coarse.cols() == 8);
  const std::vector<int> expected{0, 2, 4, 6, 8, 9, 11, 13};
  for (int i = 0; i < 8; ++i) CHECK(coarse.col(i) == fine.col(expected[i]));

  const Eigen::Matrix3Xd between = Resampling({3}, {4})(line(3));
  for (int i = 0; i < 4; ++i) CHECK((between.col(i) - line(3).col(2) * i / 3.0).norm() < 1e-15);
  CHECK(Resampling({4, 4}, {4, 4})(helix(1, 1, 3, 8)) == helix(1, 1, 3, 8));
  CHECK_THROWS_WITH(Resampling({4, 4}, {4}), "it has 1 strands, the reference 2");
}

TEST_CASE("errors are what was moved, over all times") {
  const Eigen::Matrix3Xd right = helix(0.005, 0.004, 5, 20);
  Eigen::Matrix3Xd moved = right;
  moved.col(7).x() += 2e-3;
  const std::vector<int> counts{20};
  const std::vector<ComparedState> reference{{0.1, right, 4}, {0.2, right, 1}};
  const MeasuredErrors measured =
      measure_errors({{0.1, right, 4}, {0.2, moved, 2}}, counts, reference, counts);
  CHECK(measured.errors["mean_distance"] == Approx(2e-3 / 20 / 2));
  CHECK(measured.errors["max_distance"] == Approx(2e-3));
  CHECK(measured.errors["energy"] == Approx(0.25));
  CHECK(measured.errors["length"] == 0);
  CHECK(measured.errors["curl_radius"].get<double>() > 0);
  REQUIRE(measured.at.size() == 2);
  CHECK(measured.at[0]["max_distance"] == 0);
  CHECK(measured.at[1]["time"] == 0.2);
  CHECK(measured.at[1]["max_distance"] == Approx(2e-3));

  const MeasuredErrors stretched =
      measure_errors({{0.1, 1.5 * right, 4}}, counts, reference, counts);
  CHECK(stretched.errors["curl_radius"] == Approx(0.5));
  CHECK(stretched.errors["length"] == Approx(0.5));
  CHECK(stretched.at.size() == 1);
}

TEST_CASE("a coarse helix has no error against a fine one but that of its edges") {
  const int turns = 4;
  const MeasuredErrors measured =
      measure_errors({{0.1, helix(0.005, 0.004, 5, 5 * turns + 1), 1}}, {5 * turns + 1},
                     {{0.1, helix(0.005, 0.004, 40, 40 * turns + 1), 1}}, {40 * turns + 1});
  CHECK(measured.errors["max_distance"].get<double>() < 1e-15);
  CHECK(measured.errors["curl_radius"].get<double>() < 1e-9);
}

TEST_CASE("where the reference is straight there is no error of the curl radius") {
  const MeasuredErrors measured =
      measure_errors({{0.1, line(9), 1}}, {9}, {{0.1, line(9), 1}}, {9});
  CHECK(measured.errors["curl_radius"].is_null());
  CHECK(measured.errors["mean_distance"] == 0);
}
