#include <random>

#include "collision/contact.h"
#include "tests/catch.h"
#include "tests/collision/random_strands.h"

using namespace ringlet;

namespace {

using Vertices = std::array<Eigen::Vector3d, 4>;

double penalty_energy(const Vertices& x, const Penalty& penalty) {
  return penalty.at(segment_gap(x).distance).value;
}

void check_gradient(const Vertices& x, const Penalty& penalty) {
  const SegmentGap gap = segment_gap(x);
  const DistanceEnergy energy = penalty.at(gap.distance);
  REQUIRE(energy.slope < 0);
  const double step = 1e-6, scale = -energy.slope;
  for (int i = 0; i < 4; ++i) {
    for (int c = 0; c < 3; ++c) {
      Vertices plus = x, minus = x;
      plus[i][c] += step;
      minus[i][c] -= step;
      const double difference =
          (penalty_energy(plus, penalty) - penalty_energy(minus, penalty)) / (2 * step);
      CHECK(energy.slope * gap.weights[i] * gap.normal[c] ==
            Approx(difference).margin(1e-5 * scale));
    }
  }
}

}  // namespace

TEST_CASE("the penalty is k/2 (h - d)^2 below the thickness and nothing beyond") {
  const Penalty penalty{0.1, 3};
  CHECK(penalty.at(0.04).value == Approx(0.5 * 3 * 0.06 * 0.06));
  CHECK(penalty.at(0.04).slope == Approx(-3 * 0.06));
  CHECK(penalty.at(0.04).curvature == 3);
  CHECK(penalty.at(-0.04).value == Approx(0.5 * 3 * 0.14 * 0.14));
  for (const double distance : {0.1, 0.2}) {
    CHECK(penalty.at(distance).value == 0);
    CHECK(penalty.at(distance).slope == 0);
    CHECK(penalty.at(distance).curvature == 0);
  }
}

TEST_CASE("the gradient of a contact of edges is that of differences") {
  const unsigned seed = 13;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 100; ++i) {
    Vertices x;
    for (auto& p : x) p = random_point(random, 1);
    if (segment_gap(x).distance < 1e-2) continue;  // near a crossing differences are useless
    check_gradient(x, {6, 2});
  }
}

TEST_CASE("crossing and degenerate edges are pushed apart by a finite force") {
  const std::vector<Vertices> cases{
      {{{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}}},  // crossing
      {{{-1, 0, 0}, {1, 0, 0}, {0, 0, 0}, {2, 0, 0}}},   // collinear, overlapping
      {{{0, 0, 0}, {0, 0, 0}, {-1, 0, 0}, {1, 0, 0}}},   // a point on a segment
      {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}}},    // one point
  };
  for (const Vertices& x : cases) {
    const SegmentGap gap = segment_gap(x);
    CHECK(gap.distance == 0);
    CHECK(gap.normal.norm() == Approx(1));
    for (int i = 1; i < 4; i += 2) CHECK(std::abs(gap.normal.dot(x[i] - x[i - 1])) < 1e-12);
  }
}

TEST_CASE("a contact pushes with no net force") {
  std::mt19937 random(17);
  Vertices x;
  for (auto& p : x) p = random_point(random, 1);
  const SegmentGap gap = segment_gap(x);
  CHECK(gap.weights[0] + gap.weights[1] + gap.weights[2] + gap.weights[3] ==
        Approx(0).margin(1e-15));
  CHECK(gap.weights[0] + gap.weights[1] == Approx(1));
}
