#include <numbers>

#include "core/sources/blue_noise.h"
#include "tests/catch.h"

using namespace ringlet;

namespace {

struct Spread {
  double smallest = 4;     // distance between neighbours
  double largest_gap = 0;  // largest distance of a point to its nearest neighbour
};

Spread measure(const std::vector<Eigen::Vector3d>& points) {
  Spread spread;
  for (const auto& a : points) {
    double nearest = 4;
    for (const auto& b : points) {
      if (&a != &b) nearest = std::min(nearest, (a - b).norm());
    }
    spread.smallest = std::min(spread.smallest, nearest);
    spread.largest_gap = std::max(spread.largest_gap, nearest);
  }
  return spread;
}

}  // namespace

TEST_CASE("blue noise on a sphere keeps its points apart and leaves no holes") {
  for (const double lowest : {-1.0, 0.0}) {
    for (const int count : {50, 200, 2000}) {
      for (const unsigned seed : {1u, 2u, 3u}) {
        CAPTURE(lowest, count, seed);
        const auto points = blue_noise_on_sphere(count, lowest, seed);
        REQUIRE(static_cast<int>(points.size()) == count);
        for (const auto& point : points) {
          REQUIRE(point.norm() == Approx(1));
          REQUIRE(point.y() >= lowest - 1e-15);
        }
        const double ideal = hexagonal_spacing(2 * std::numbers::pi * (1 - lowest), count);
        const auto [smallest, largest_gap] = measure(points);
        CHECK(smallest > 0.6 * ideal);
        CHECK(smallest < ideal);
        CHECK(largest_gap < 1.5 * ideal);
      }
    }
  }
}

TEST_CASE("blue noise is the same for the same seed and differs for others") {
  const auto points = blue_noise_on_sphere(300, -1, 5);
  CHECK(blue_noise_on_sphere(300, -1, 5) == points);
  CHECK(blue_noise_on_sphere(300, -1, 6) != points);
}

TEST_CASE("blue noise of very few points") {
  CHECK(blue_noise_on_sphere(1, -1, 1).size() == 1);
  const auto two = blue_noise_on_sphere(2, -1, 1);
  REQUIRE(two.size() == 2);
  CHECK((two[0] - two[1]).norm() > 1);
}
