#include <array>

#include "core/collider.h"
#include "tests/catch.h"
#include "tests/collision/make_plugin.h"
#include "tests/collision/random_strands.h"

using namespace ringlet;

namespace {

Proximity proximity(const Collider& collider, const Eigen::Vector3d& point) {
  std::optional<Proximity> found;
  collider.near({&point, 1}, 1e9, {&found, 1});
  REQUIRE(found.has_value());
  return *found;
}

double distance(const Collider& collider, const Eigen::Vector3d& point) {
  return proximity(collider, point).distance;
}

// What holds of every exact signed distance: the normal is its gradient and has unit length, and
// walking the distance against the normal leads to the surface.
void check_near(const Collider& collider, const Eigen::Vector3d& point) {
  const Proximity at = proximity(collider, point);
  CHECK(at.normal.norm() == Approx(1));
  CHECK(distance(collider, point - at.distance * at.normal) == Approx(0).margin(1e-9));
  const double step = 1e-6;
  for (int c = 0; c < 3; ++c) {
    const Eigen::Vector3d move = step * Eigen::Vector3d::Unit(c);
    const double slope =
        (distance(collider, point + move) - distance(collider, point - move)) / (2 * step);
    CHECK(at.normal[c] == Approx(slope).margin(1e-5));
  }
}

}  // namespace

TEST_CASE("analytic colliders: distance and normal agree with differences") {
  const auto json =
      GENERATE(R"({"type": "sphere", "centre": [0.1, 0.2, 0.3], "radius": 0.5})",
               R"({"type": "capsule", "from": [-0.4, 0, 0], "to": [0.3, 0.5, 0.1], "radius": 0.3})",
               R"({"type": "capsule", "from": [0.1, 0, 0], "to": [0.1, 0, 0], "radius": 0.6})",
               R"({"type": "box", "centre": [0.1, 0, 0], "size": [1, 0.6, 1.4]})",
               R"({"type": "plane", "point": [0, 0.2, 0], "normal": [1, 2, 3]})");
  CAPTURE(json);
  const auto collider = make_plugin<Collider>(Json::parse(json));
  const unsigned seed = 41;
  CAPTURE(seed);
  std::mt19937 random(seed);
  int inside = 0;
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d point = random_point(random, 1);
    check_near(*collider, point);
    if (distance(*collider, point) < 0) ++inside;
  }
  CHECK((inside > 0 && inside < 100));
}

TEST_CASE("analytic colliders: known distances") {
  const auto box = make_plugin<Collider>({{"type", "box"}, {"size", {2, 4, 6}}});
  CHECK(distance(*box, {0, 0, 0}) == Approx(-1));
  CHECK(distance(*box, {4, 6, 0}) == Approx(5));
  CHECK(distance(*box, {0, 0, 4}) == Approx(1));
  const auto capsule = make_plugin<Collider>(
      {{"type", "capsule"}, {"from", {0, 0, 0}}, {"to", {0, 0, 2}}, {"radius", 0.5}});
  CHECK(distance(*capsule, {1, 0, 1}) == Approx(0.5));
  CHECK(distance(*capsule, {0, 0, 3}) == Approx(0.5));
  CHECK(distance(*capsule, {0, 0.25, 1}) == Approx(-0.25));
  const auto plane = make_plugin<Collider>({{"type", "plane"}, {"normal", {0, 0, 5}}});
  CHECK(distance(*plane, {7, 8, 3}) == Approx(3));
}

TEST_CASE("analytic colliders: a finite normal where it is not unique") {
  const auto json =
      GENERATE(R"({"type": "sphere", "radius": 0.5})",
               R"({"type": "capsule", "from": [0, 0, 0], "to": [1, 0, 0], "radius": 0.3})",
               R"({"type": "capsule", "from": [0, 0, 0], "to": [0, 0, 0], "radius": 0.3})",
               R"({"type": "box", "size": [1, 1, 1]})");
  const auto collider = make_plugin<Collider>(Json::parse(json));
  const Proximity centre = proximity(*collider, Eigen::Vector3d::Zero());
  CHECK(centre.normal.norm() == Approx(1));
  CHECK(centre.distance < 0);
}

TEST_CASE("analytic colliders: points out of reach are not near, deep ones are") {
  const auto sphere = make_plugin<Collider>({{"type", "sphere"}, {"radius", 1}});
  const std::array<Eigen::Vector3d, 3> points{{{1.05, 0, 0}, {1.2, 0, 0}, {0.1, 0, 0}}};
  std::array<std::optional<Proximity>, 3> found;
  sphere->near(points, 0.1, found);
  CHECK(found[0].has_value());
  CHECK_FALSE(found[1].has_value());
  CHECK(found[2].has_value());
}
