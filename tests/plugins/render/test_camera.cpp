#include <Eigen/Geometry>
#include <cmath>

#include "core/random.h"
#include "plugins/render/camera.h"
#include "tests/catch.h"

using namespace ringlet;
using Eigen::Vector3d;

namespace {

Vector3d random_vector(Random& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

}  // namespace

TEST_CASE("a camera frames all that was added, and no more than it must") {
  Random random(3);
  for (int trial = 0; trial < 50; ++trial) {
    const Vector3d place = 10 * random_vector(random);
    Framing framing(random_vector(random), random_vector(random), random.uniform(0.2, 1.5), 640,
                    random.uniform() < 0.5 ? 360 : 900);
    std::vector<Vector3d> rim;
    for (int i = 0; i < 40; ++i) {
      const Vector3d centre = place + random_vector(random);
      const double radius = random.uniform(0, 0.2);
      framing.add(centre, radius);
      for (int j = 0; j < 200; ++j) {
        rim.push_back(centre + radius * random_vector(random).normalized());
      }
    }
    const Camera camera = framing.camera();
    double least_margin = 1;
    for (const Vector3d& point : rim) {
      const auto seen = camera.project(point);
      REQUIRE(seen);
      const double across = seen->x() / camera.width(), down = seen->y() / camera.height();
      least_margin = std::min({least_margin, across, 1 - across, down, 1 - down});
    }
    CHECK(least_margin >= 0.04 - 1e-9);
    CHECK(least_margin < 0.06);
  }
}

TEST_CASE("a single point, and nothing at all, are framed too") {
  Framing nothing(Vector3d::UnitZ(), Vector3d::UnitY(), 0.5, 64, 48);
  const auto origin = nothing.camera().project(Vector3d::Zero());
  REQUIRE(origin);
  CHECK(origin->isApprox(Eigen::Vector2d(32, 24)));
  Framing point(Vector3d::UnitY(), Vector3d::UnitY(), 0.5, 64, 48);
  point.add({1, 2, 3}, 0);
  const auto seen = point.camera().project({1, 2, 3});
  REQUIRE(seen);
  CHECK(seen->isApprox(Eigen::Vector2d(32, 24)));
}

TEST_CASE("the ray through where a point is seen leads to it") {
  Random random(5);
  const Camera camera({1, 2, 3}, {0.5, 0.1, -1}, Vector3d::UnitY(), 0.7, 320, 200);
  for (int trial = 0; trial < 100; ++trial) {
    const Vector3d point = random_vector(random);
    const auto seen = camera.project(point);
    REQUIRE(seen);
    const Vector3d way = camera.direction_through(seen->x(), seen->y());
    CHECK(way.cross(point - camera.position()).norm() < 1e-12);
  }
  CHECK_FALSE(camera.project({1, 2.5, 5}));
  const auto target = camera.project({0.5, 0.1, -1});
  REQUIRE(target);
  CHECK(target->isApprox(Eigen::Vector2d(160, 100)));
  // What is higher is further up in the picture.
  CHECK(camera.project({0.5, 0.2, -1})->y() < 100);
}
