#include <random>

#include "collision/segment_distance.h"
#include "collision/segment_gap.h"
#include "tests/catch.h"
#include "tests/collision/random_strands.h"

using namespace ringlet;

namespace {

using Vertices = std::array<Eigen::Vector3d, 4>;

double distance_of(const Vertices& x) {
  const auto at = [&](int i) { return from_eigen(x[i]); };
  return std::sqrt(closest_points(at(0), at(1), at(2), at(3)).squared_distance);
}

/// What segment_gap() minimises, tried at a grid of places.
double least_of_grid(const Vertices& x, int places) {
  double least = std::numeric_limits<double>::max();
  for (int i = 0; i <= places; ++i) {
    for (int j = 0; j <= places; ++j) {
      const double s = double(i) / places, t = double(j) / places;
      const Eigen::Vector3d apart = (1 - s) * x[0] + s * x[1] - (1 - t) * x[2] - t * x[3];
      const double growth = 1 + 0.01 * ((s - 0.5) * (s - 0.5) + (t - 0.5) * (t - 0.5));
      least = std::min(least, apart.norm() * std::sqrt(growth));
    }
  }
  return least;
}

/// Two segments of length 2, a millimetre apart, the second turned by an angle about their common
/// normal.
Vertices nearly_parallel(double angle) {
  const Eigen::Vector3d half(std::cos(angle), std::sin(angle), 0), up(0, 0, 1e-3);
  return {-Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitX(), up - half, up + half};
}

}  // namespace

TEST_CASE("the gap is the least of what it minimises, and hardly more than the distance") {
  std::mt19937 random(61);
  for (int i = 0; i < 200; ++i) {
    Vertices x;
    for (auto& p : x) p = random_point(random, 1);
    if (i % 2 == 1) x[3] = x[2] + 1.3 * (x[1] - x[0]) + random_point(random, 1e-3);
    const double gap = segment_gap(x).distance, distance = distance_of(x);
    CHECK(gap >= distance);
    CHECK(gap <= 1.0025 * distance);
    CHECK(gap <= least_of_grid(x, 100) * (1 + 1e-9));
    CHECK(gap == Approx(least_of_grid(x, 400)).epsilon(1e-3).margin(1e-2));
  }
}

TEST_CASE("the derivative of the gap is that of differences, for parallel edges, too") {
  std::mt19937 random(67);
  for (const double angle : {0.0, 1e-7, 1e-5, 1e-4, 1e-3, 1e-2, 0.1}) {
    CAPTURE(angle);
    Vertices x = nearly_parallel(angle);
    for (auto& p : x) p += random_point(random, 1e-5);
    const SegmentGap gap = segment_gap(x);
    const double step = 1e-8;
    for (int i = 0; i < 4; ++i) {
      for (int c = 0; c < 3; ++c) {
        Vertices plus = x, minus = x;
        plus[i][c] += step;
        minus[i][c] -= step;
        const double difference =
            (segment_gap(plus).distance - segment_gap(minus).distance) / (2 * step);
        CHECK(gap.weights[i] * gap.normal[c] == Approx(difference).margin(1e-4));
      }
    }
  }
}

TEST_CASE("the derivative of the gap does not jump as edges turn through parallel") {
  const auto weight_at = [](double angle) {
    return segment_gap(nearly_parallel(angle)).weights[0];
  };
  CHECK(weight_at(0) == Approx(0.5).epsilon(1e-3));
  double last = weight_at(-2e-3), largest = 0;
  for (double angle = -2e-3; angle < 2e-3; angle += 1e-6) {
    largest = std::max(largest, std::abs(weight_at(angle) - last));
    last = weight_at(angle);
  }
  CHECK(largest < 0.02);
}

TEST_CASE("gaps in lanes are those of single pairs") {
  std::mt19937 random(71);
  const Strands strands = random_bundle(random, 30);
  const StrandGroups groups(strands);
  const VertexField x = positions_with_pads(groups, rest_positions(strands));
  std::vector<EdgePair> pairs;
  for (int n = 0; n < lane_count - 1; ++n) {
    pairs.push_back({strands.first(n), strands.first(n + 1)});
  }
  const SegmentGaps gaps(pairs, x, 1);
  CHECK(SegmentGaps(pairs, x, 1e-9).distances()[0] >= 1e-9);
  for (std::size_t n = 0; n < pairs.size(); ++n) {
    const auto [a, b] = pairs[n];
    const SegmentGap expected = segment_gap({x.get(a), x.get(a + 1), x.get(b), x.get(b + 1)});
    const SegmentGap found = gaps.of(static_cast<int>(n));
    CHECK(found.distance == Approx(expected.distance).epsilon(1e-12));
    CHECK(gaps.distances()[n] == found.distance);
    CHECK((found.normal - expected.normal).norm() < 1e-9);
    for (int i = 0; i < 4; ++i) CHECK(found.weights[i] == Approx(expected.weights[i]).margin(1e-9));
  }
}
