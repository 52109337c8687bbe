#include <Eigen/Geometry>
#include <algorithm>

#include "core/random.h"
#include "plugins/render/bundle_tracing.h"
#include "plugins/render/curves.h"
#include "tests/catch.h"
#include "tests/plugins/render/curls.h"

using namespace ringlet;
using Eigen::Vector3d;
using Eigen::Vector3f;

namespace {

Vector3d curve_at(const LanePoints* points, int lane, double u) {
  const double v = 1 - u;
  const double weights[4] = {-0.5 * u * v * v, 0.5 * (2 + u * u * (3 * u - 5)),
                             0.5 * (2 + v * v * (3 * v - 5)), -0.5 * v * u * u};
  Vector3d sum = Vector3d::Zero();
  for (int i = 0; i < 4; ++i) sum += weights[i] * points[i].of(lane).cast<double>();
  return sum;
}

/// The smallest distance of a hair from a line.
double distance_from(const LanePoints* points, int lane, const Vector3d& origin,
                     const Vector3d& way) {
  double least = 1;
  for (int i = 0; i <= 400; ++i) {
    least = std::min(least, (curve_at(points, lane, i / 400.0) - origin).cross(way).norm());
  }
  return least;
}

}  // namespace

TEST_CASE("rays meet the hairs that they pass, and no others") {
  const ChildParameters parameters{40, 2e-4, 1, 0.5, 0};
  const Bundles bundles = make_bundles(curls(1, 60), parameters, Vector3d::Zero());
  Random random(7);
  int met = 0, missed = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const auto& segment = bundles.segments[static_cast<std::size_t>(
        random.uniform(0, static_cast<double>(bundles.segments.size())))];
    const LanePoints* points = &bundles.points[segment.point];
    const float* radii = &bundles.radii[segment.point + 1];
    const Vector3d aim = curve_at(points, 3, random.uniform()) +
                         1e-3 * Vector3d(random.uniform(), random.uniform(), random.uniform());
    const Vector3d eye =
        aim + 0.1 * Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    const Vector3d way = (aim - eye).normalized();
    const RayFrame ray(eye.cast<float>(), way.cast<float>());
    const LaneHits hits = trace(points, radii, ray, 0, 10);
    bool any = false;
    for (int lane = 0; lane < hair_lanes; ++lane) {
      const double distance = distance_from(points, lane, eye, way);
      const bool is_hit = hits.distance[lane] < 10;
      any = any || is_hit;
      // Straight pieces are a little beside the curve.
      if (distance < radii[1] - 8e-5) CHECK(is_hit);
      if (distance > radii[0] + 8e-5) CHECK_FALSE(is_hit);
      if (!is_hit) {
        ++missed;
        continue;
      }
      ++met;
      const Vector3d there = curve_at(points, lane, hits.u[lane]);
      CHECK((there - eye - double{hits.distance[lane]} * way).norm() < radii[0] + 8e-5);
    }
    if (any) CHECK(may_meet(tube_around(points, radii[0]), ray, 0, 10));
  }
  CHECK(met > 100);
  CHECK(missed > 100);
}

TEST_CASE("boxes and tubes hold all that can be met, and not much more") {
  const ChildParameters parameters{16, 1e-4, 1, 0.5, 0};
  const Bundles bundles = make_bundles(curls(1, 60), parameters, Vector3d::Zero());
  for (const auto& segment : bundles.segments) {
    const LanePoints* points = &bundles.points[segment.point];
    const auto [low, high] = bounds(points, 1e-4F);
    const Tube tube = tube_around(points, 1e-4F);
    for (int lane = 0; lane < hair_lanes; ++lane) {
      for (const double u : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const Vector3f point = curve_at(points, lane, u).cast<float>();
        CHECK((point.array() > low.array()).all());
        CHECK((point.array() < high.array()).all());
        const RayFrame ray(point - Vector3f::UnitX(), Vector3f::UnitX());
        CHECK(may_meet(tube, ray, 0, 10));
        CHECK_FALSE(may_meet(tube, ray, 0, 0.9F));
        CHECK_FALSE(may_meet(tube, ray, 1.1F, 10));
      }
    }
    const RayFrame beside(tube.middle + Vector3f(-1, 0, 0.02F), Vector3f::UnitX());
    CHECK_FALSE(may_meet(tube, beside, 0, 10));
  }
}

TEST_CASE("the slope of a curve is its derivative") {
  for (const double u : {0.0, 0.3, 0.8, 1.0}) {
    const Eigen::Array4f slope = catmull_rom_slope(static_cast<float>(u));
    LanePoints points[4]{};
    for (int i = 0; i < 4; ++i) points[i].x[i] = 1;
    for (int i = 0; i < 4; ++i) {
      const double difference =
          (curve_at(points, i, u + 1e-5) - curve_at(points, i, u - 1e-5)).x() / 2e-5;
      CHECK(std::abs(difference - double{slope[i]}) < 1e-5);
    }
  }
}
