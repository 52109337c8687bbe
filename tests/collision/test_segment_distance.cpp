#include <algorithm>
#include <random>

#include "collision/segment_distance.h"
#include "tests/catch.h"

using namespace ringlet;

namespace {

using V = Vector3<double>;

// The least distance of a point from many points of a segment: an upper bound of that from the
// segment, by a convex search that knows nothing of closed forms.
template <class F>
double minimize_convex(const F& f) {
  double low = 0, high = 1;
  for (int i = 0; i < 100; ++i) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    (f(a) <= f(b) ? high : low) = f(a) <= f(b) ? b : a;
  }
  return std::min({f(0.5 * (low + high)), f(0.0), f(1.0)});
}

double distance_by_search(const V& p0, const V& p1, const V& q0, const V& q1) {
  return minimize_convex([&](double s) {
    const V p = p0 + s * (p1 - p0);
    return minimize_convex([&](double t) { return norm(p - (q0 + t * (q1 - q0))); });
  });
}

void check(const V& p0, const V& p1, const V& q0, const V& q1) {
  const auto found = closest_points(p0, p1, q0, q1);
  CHECK((found.s >= 0 && found.s <= 1 && found.t >= 0 && found.t <= 1));
  const double at_parameters = norm((p0 + found.s * (p1 - p0)) - (q0 + found.t * (q1 - q0)));
  const double size = norm(p1 - p0) + norm(q1 - q0) + norm(q0 - p0);
  CHECK(sqrt(found.squared_distance) == Approx(at_parameters).margin(1e-14 * size));
  CHECK(at_parameters == Approx(distance_by_search(p0, p1, q0, q1)).margin(1e-7 * size));
}

V random_vector(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return {normal(random), normal(random), normal(random)};
}

}  // namespace

TEST_CASE("closest points of random segments are those of a convex search") {
  const unsigned seed = 7;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 200; ++i) {
    check(random_vector(random), random_vector(random), random_vector(random),
          random_vector(random));
  }
}

TEST_CASE("closest points of degenerate segments are those of a convex search") {
  const unsigned seed = 11;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 40; ++i) {
    const V p = random_vector(random), q = random_vector(random), d = random_vector(random);
    check(p, p + d, q, q + 0.7 * d);                           // parallel
    check(p, p + d, q, q - 1.3 * d);                           // antiparallel
    check(p, p + d, q, q + d + 1e-8 * random_vector(random));  // nearly parallel
    check(p, p + d, p + 0.5 * d, p + 2.0 * d);                 // collinear, overlapping
    check(p, p + d, p + 1.5 * d, p + 2.0 * d);                 // collinear, apart
    check(p, p + d, p + d, q);                                 // sharing an end
    check(p, p + d, p + 0.3 * d - 0.2 * q, p + 0.3 * d + q);   // crossing
    check(p, p + d, p + 0.25 * d, q);                          // an end touching the inside
    check(p, p, q, q + d);                                     // a point and a segment
    check(p, p + d, q, q);                                     // a segment and a point
    check(p, p, q, q);                                         // two points
    check(p, p, p, p);                                         // the same point
    check(p, p + 1e-7 * d, q, q + d);                          // very different lengths
  }
}

TEST_CASE("an end point is not the line through it") {
  // The lines cross at (5, 0, 0), far from both segments.
  const auto found = closest_points<double>({0, 0, 0}, {1, 0, 0}, {5, 1, 0}, {5, 2, 0});
  CHECK(found.squared_distance == Approx(17.0));
  CHECK(found.s == 1.0);
  CHECK(found.t == 0.0);
}

TEST_CASE("lanes find the same closest points as doubles") {
  const unsigned seed = 3;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const auto broadcast = [](const V& v) { return Vector3<Pack>{Pack(v.x), Pack(v.y), Pack(v.z)}; };
  for (int i = 0; i < 100; ++i) {
    const V p0 = random_vector(random), p1 = random_vector(random), q0 = random_vector(random);
    const V q1 = i % 2 == 0 ? random_vector(random) : q0 + 2.0 * (p1 - p0);
    const auto one = closest_points(p0, p1, q0, q1);
    const auto lanes = closest_points(broadcast(p0), broadcast(p1), broadcast(q0), broadcast(q1));
    for (int lane = 0; lane < lane_count; ++lane) {
      CHECK(lanes.squared_distance[lane] == Approx(one.squared_distance).epsilon(1e-10));
    }
  }
}
