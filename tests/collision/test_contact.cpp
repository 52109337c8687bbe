#include <random>

#include "collision/contact.h"
#include "collision/contact_law.h"
#include "tests/catch.h"
#include "tests/collision/make_plugin.h"
#include "tests/collision/random_strands.h"

using namespace ringlet;

namespace {

using Vertices = std::array<Eigen::Vector3d, 4>;

std::unique_ptr<ContactEnergy> make_response(const std::string& type) {
  return make_plugin<ContactEnergy>(type);
}

void check_gradient(const Vertices& x, const ContactLaw& law) {
  const auto value_at = [&](const Vertices& at) { return law.at(segment_gap(at).distance).value; };
  const SegmentGap gap = segment_gap(x);
  const DistanceEnergy energy = law.at(gap.distance);
  REQUIRE(energy.slope < 0);
  const double step = 1e-6, scale = -energy.slope;
  for (int i = 0; i < 4; ++i) {
    for (int c = 0; c < 3; ++c) {
      Vertices plus = x, minus = x;
      plus[i][c] += step;
      minus[i][c] -= step;
      const double difference = (value_at(plus) - value_at(minus)) / (2 * step);
      CHECK(energy.slope * gap.weights[i] * gap.normal[c] ==
            Approx(difference).margin(1e-5 * scale));
    }
  }
}

}  // namespace

TEST_CASE("the penalty is k/2 (h - d)^2 below the thickness") {
  const auto penalty = make_response("penalty");
  CHECK(penalty->at(0.04, 0.1, 3).value == Approx(0.5 * 3 * 0.06 * 0.06));
  CHECK(penalty->at(0.04, 0.1, 3).slope == Approx(-3 * 0.06));
  CHECK(penalty->at(0.04, 0.1, 3).curvature == 3);
  CHECK(penalty->at(-0.04, 0.1, 3).value == Approx(0.5 * 3 * 0.14 * 0.14));
}

TEST_CASE("the barrier has no bound at distance zero, and at half the thickness a known force") {
  const auto barrier = make_response("barrier");
  CHECK(barrier->at(0.05, 0.1, 3).slope == Approx(-3 * 0.1 * (std::log(2) + 0.5) / 2));
  CHECK(barrier->at(1e-300, 0.1, 3).value > 200 * 3 * 0.01);
  for (const double d : {0.0, -0.01}) CHECK(!std::isfinite(barrier->at(d, 0.1, 3).value));
}

TEST_CASE("responses push apart below the thickness, are convex, and end smoothly") {
  const std::string type = GENERATE("penalty", "barrier");
  const auto response = make_response(type);
  const double h = 0.1, k = 3;
  for (const double d : {h, 2 * h}) {
    const DistanceEnergy beyond = response->at(d, h, k);
    CHECK(beyond.value == 0);
    CHECK(beyond.slope == 0);
    CHECK(beyond.curvature == 0);
  }
  const DistanceEnergy end = response->at(h * (1 - 1e-7), h, k);
  CHECK(end.value < 1e-12 * k * h * h);
  CHECK(std::abs(end.slope) < 1e-6 * k * h);
  if (type == "barrier") CHECK(end.curvature < 1e-5 * k);
  for (double d = 0.001; d < h; d += 0.007) {
    const double step = 1e-6 * d;
    const DistanceEnergy energy = response->at(d, h, k);
    const DistanceEnergy plus = response->at(d + step, h, k), minus = response->at(d - step, h, k);
    CHECK(energy.slope < 0);
    CHECK(energy.curvature > 0);
    CHECK(energy.slope == Approx((plus.value - minus.value) / (2 * step)).epsilon(1e-5));
    CHECK(energy.curvature == Approx((plus.slope - minus.slope) / (2 * step)).epsilon(1e-5));
    CHECK(response->at(d, h, 2 * k).value == Approx(2 * energy.value));
  }
}

TEST_CASE("the gradient of a contact of edges is that of differences") {
  const auto response = make_response(GENERATE("penalty", "barrier"));
  const unsigned seed = 13;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 100; ++i) {
    Vertices x;
    for (auto& p : x) p = random_point(random, 1);
    if (segment_gap(x).distance < 1e-2) continue;  // near a crossing differences are useless
    check_gradient(x, {response.get(), 6, 2});
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
  CHECK(gap.weights[0] + gap.weights[1] == Approx(1).epsilon(2.5e-3));
}
