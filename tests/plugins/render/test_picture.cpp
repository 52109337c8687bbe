#include <tbb/global_control.h>

#include "plugins/render/renderer.h"
#include "tests/catch.h"
#include "tests/plugins/render/curls.h"

using namespace ringlet;
using Eigen::Vector3d;

namespace {

RenderParameters small_picture() {
  RenderParameters parameters;
  parameters.width = 64;
  parameters.height = 48;
  parameters.samples = 4;
  parameters.light.direction = Vector3d(0, 1, 0);
  return parameters;
}

/// A thick hair that stands in the middle of the picture, 20 cm high.
DrawnScene upright_hair() {
  DrawnScene subject;
  subject.strands.vertex_counts = {5};
  subject.strands.radii.assign(5, 0.01);
  subject.strands.positions.resize(3, 5);
  for (int i = 0; i < 5; ++i) subject.strands.positions.col(i) << 0, 0.05 * i, 0;
  return subject;
}

const Camera in_front({0, 0.12, 0.5}, {0, 0.1, 0}, Vector3d::UnitY(), 0.5, 64, 48);

int brightness(const Picture& picture, const Vector3d& point, const Camera& camera = in_front) {
  const auto seen = camera.project(point);
  REQUIRE(seen);
  const auto* pixel = picture.pixel(static_cast<int>(seen->x()), static_cast<int>(seen->y()));
  return pixel[0] + pixel[1] + pixel[2];
}

}  // namespace

TEST_CASE("a strand is seen where it is, and the background elsewhere") {
  const RenderParameters parameters = small_picture();
  for (const int children : {0, 400}) {
    RenderParameters with = parameters;
    with.children = children;
    with.child_radius = 1e-3;
    const Picture picture = draw(upright_hair(), in_front, Vector3d::UnitY(), with);
    CHECK(picture.bytes.size() == 3 * 64 * 48);
    const int background = brightness(picture, {0.1, 0.1, 0});
    CHECK(background > 3 * 200);
    for (const double height : {0.02, 0.1, 0.16}) {
      CHECK(brightness(picture, {0, height, 0}) < 0.7 * background);
      CHECK(brightness(picture, {0.03, height, 0}) == background);
      CHECK(brightness(picture, {-0.03, height, 0}) == background);
    }
    CHECK(brightness(picture, {0, 0.222, 0}) == background);
  }
}

TEST_CASE("the ground looks like the background, but for shadows") {
  DrawnScene subject = upright_hair();
  subject.shapes.push_back(Plane{{0, -0.05, 0}, Vector3d::UnitY()});
  subject.shapes.push_back(Ball{{0.1, 0.1, -0.1}, 0.03});
  RenderParameters parameters = small_picture();
  parameters.samples = 64;
  const Camera above({0, 0.8, 0.8}, {0, 0, 0}, Vector3d::UnitY(), 0.6, 64, 48);
  const Picture picture = draw(subject, above, Vector3d::UnitY(), parameters);
  const int lit = brightness(picture, {0.3, -0.05, 0.2}, above);
  CHECK(lit > 3 * 195);
  CHECK(brightness(picture, {0.1, -0.05, -0.1}, above) < 0.8 * lit);
  subject.shapes.pop_back();
  const Picture without = draw(subject, above, Vector3d::UnitY(), parameters);
  CHECK(brightness(without, {0.1, -0.05, -0.1}, above) > 0.95 * lit);
}

TEST_CASE("colliders of every kind are seen") {
  const std::vector<DrawnShape> shapes{
      Ball{{0, 0.1, 0}, 0.03}, Capsule{{-0.1, 0.1, 0}, {0.1, 0.1, 0}, 0.03},
      Triangles{{{-0.1, 0.05, 0}, {0.1, 0.05, 0}, {0, 0.2, 0}}, {{0, 1, 2}}}};
  for (const DrawnShape& shape : shapes) {
    DrawnScene subject;
    subject.shapes = {shape};
    const Picture picture = draw(subject, in_front, Vector3d::UnitY(), small_picture());
    const auto seen = in_front.project({0, 0.1, 0});
    const auto* pixel = picture.pixel(static_cast<int>(seen->x()), static_cast<int>(seen->y()));
    CHECK(pixel[0] > pixel[2] + 10);
    CHECK(brightness(picture, {0.15, 0.2, 0}) > 3 * 200);
  }
}

TEST_CASE("a picture is the same on any number of threads, and far from the origin") {
  DrawnScene subject{curls(4, 40), {Ball{{0.05, -0.02, 0}, 0.02}}};
  RenderParameters parameters = small_picture();
  const Camera camera({0.05, 0.05, 0.3}, {0.05, 0.01, 0}, Vector3d::UnitY(), 0.5, 64, 48);
  for (const int children : {0, 50}) {
    parameters.children = children;
    std::vector<Picture> pictures;
    for (const std::size_t threads : {1U, 2U}) {
      const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
      pictures.push_back(draw(subject, camera, Vector3d::UnitY(), parameters));
    }
    CHECK(pictures[0].bytes == pictures[1].bytes);
    CHECK(std::adjacent_find(pictures[0].bytes.begin(), pictures[0].bytes.end(),
                             [](auto a, auto b) { return std::abs(a - b) > 60; }) !=
          pictures[0].bytes.end());
  }
  const Vector3d away(1e6, 0, 0);
  DrawnScene far = upright_hair();
  far.strands.positions.colwise() += away;
  const Camera there(Vector3d(0, 0.12, 0.5) + away, Vector3d(0, 0.1, 0) + away, Vector3d::UnitY(),
                     0.5, 64, 48);
  const Picture near_picture = draw(upright_hair(), in_front, Vector3d::UnitY(), small_picture());
  const Picture far_picture = draw(far, there, Vector3d::UnitY(), small_picture());
  std::size_t others = 0;
  for (std::size_t i = 0; i < near_picture.bytes.size(); ++i) {
    others += std::abs(near_picture.bytes[i] - far_picture.bytes[i]) > 8 ? 1U : 0U;
  }
  CHECK(others < 20);
}

TEST_CASE("hair without melanin is brighter") {
  RenderParameters parameters = small_picture();
  parameters.children = 400;
  parameters.child_radius = 1e-3;
  parameters.light.direction = Vector3d(0, 0.3, 1).normalized();
  parameters.samples = 32;
  std::vector<int> brightnesses;
  for (const double melanin : {1.0, 0.6, 0.1}) {
    parameters.melanin = melanin;
    const Picture picture = draw(upright_hair(), in_front, Vector3d::UnitY(), parameters);
    brightnesses.push_back(brightness(picture, {0, 0.1, 0}));
  }
  CHECK(brightnesses[0] < brightnesses[1]);
  CHECK(brightnesses[1] < brightnesses[2]);
}
