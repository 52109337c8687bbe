#include <cstring>

#include "plugins/render/bundles.h"
#include "tests/catch.h"
#include "tests/plugins/render/curls.h"

using namespace ringlet;
using Eigen::Vector3d;

namespace {

constexpr int vertices = 60;
const ChildParameters frizzy{40, 5e-5, 0.8, 0.7, 0};

/// visit(strand, vertex, point, hair) for every point of every hair.
template <class Visit>
void for_each_point(const Bundles& bundles, int strands, const Visit& visit) {
  const auto per_strand = static_cast<int>(bundles.ends.size()) / hair_lanes / strands;
  for (int bundle = 0; bundle < strands * per_strand; ++bundle) {
    const LanePoints* points = &bundles.points[static_cast<std::size_t>(bundle * (vertices + 2))];
    for (int lane = 0; lane < hair_lanes; ++lane) {
      const int hair = bundle * hair_lanes + lane;
      if (bundles.ends[static_cast<std::size_t>(hair)] < 0) continue;
      for (int i = 0; i < vertices; ++i) {
        visit(bundle / per_strand, i, Vector3d(points[i + 1].of(lane).cast<double>()), hair);
      }
    }
  }
}

/// The greatest distance of a point of a child from its vertex, in radii of the strand.
double farthest(const StrandShapes& strands, const ChildParameters& parameters) {
  const Vector3d origin(0.1, 0.2, -0.3);
  const Bundles bundles = make_bundles(strands, parameters, origin);
  double largest = 0;
  int points = 0;
  for_each_point(bundles, 3, [&](int strand, int i, const Vector3d& point, int) {
    const int v = strand * vertices + i;
    const double distance = (point + origin - strands.positions.col(v)).norm();
    largest = std::max(largest, distance / strands.radii[static_cast<std::size_t>(v)]);
    ++points;
  });
  CHECK(points == 3 * parameters.count * vertices);
  return largest;
}

}  // namespace

TEST_CASE("children stay within the radius of their strand, and fill it") {
  const StrandShapes strands = curls(3, vertices);
  for (const int count : {1, 16, 17, 100}) {
    ChildParameters parameters = frizzy;
    parameters.count = count;
    CHECK(farthest(strands, parameters) < 0.8001);
    parameters.frizz = 0;
    CHECK(farthest(strands, parameters) < 0.8001);
    if (count == 100) CHECK(farthest(strands, parameters) > 0.75);
  }
  ChildParameters strays = frizzy;
  strays.strays = 0.5;
  CHECK(farthest(strands, strays) > 1);
}

TEST_CASE("the same strands have the same children, others have others") {
  const StrandShapes strands = curls(3, vertices);
  const Bundles first = make_bundles(strands, frizzy, Vector3d::Zero());
  const Bundles second = make_bundles(strands, frizzy, Vector3d::Zero());
  REQUIRE(first.points.size() == second.points.size());
  CHECK(std::memcmp(first.points.data(), second.points.data(),
                    first.points.size() * sizeof(LanePoints)) == 0);
  CHECK(first.ends == second.ends);
  CHECK(first.radii == second.radii);

  // Hairs beside a vertex are all in other places, and move apart and together along the strand.
  std::vector<std::vector<Vector3d>> offsets(first.ends.size());
  for_each_point(first, 3, [&](int strand, int i, const Vector3d& point, int hair) {
    offsets[static_cast<std::size_t>(hair)].push_back(point -
                                                      strands.positions.col(strand * vertices + i));
  });
  double change = 0;
  for (std::size_t a = 1; a < offsets.size(); ++a) {
    if (offsets[a].empty() || offsets[a - 1].empty()) continue;
    CHECK((offsets[a][5] - offsets[a - 1][5]).norm() > 1e-7);
    const double here = (offsets[a][5] - offsets[a - 1][5]).norm();
    const double there = (offsets[a][30] - offsets[a - 1][30]).norm();
    change = std::max(change, std::abs(here - there));
  }
  CHECK(change > 1e-4);
}

TEST_CASE("frames along a strand turn with it and not around it") {
  Eigen::Matrix3Xd arc(3, 30);
  for (int i = 0; i < 30; ++i) arc.col(i) << std::cos(0.2 * i), std::sin(0.2 * i), 0;
  const StrandFrames frames = parallel_frames(arc);
  const double height = frames.first[0].z(), other = frames.second[0].z();
  for (std::size_t i = 0; i < 30; ++i) {
    // In a plane what points out of it goes on to do so.
    CHECK(std::abs(frames.first[i].z() - height) < 1e-12);
    CHECK(std::abs(frames.second[i].z() - other) < 1e-12);
    CHECK(std::abs(frames.first[i].dot(frames.second[i])) < 1e-12);
    CHECK(std::abs(frames.first[i].norm() - 1) < 1e-12);
  }
}

TEST_CASE("strands of one vertex, or all in one point, are no problem") {
  StrandShapes strands = curls(1, 5);
  strands.vertex_counts = {1, 4};
  strands.positions.rightCols(4).setZero();
  const Bundles bundles = make_bundles(strands, frizzy, Vector3d::Zero());
  for (const LanePoints& points : bundles.points) {
    for (int lane = 0; lane < hair_lanes; ++lane) CHECK(points.of(lane).allFinite());
  }
  CHECK(bundles.segments.size() == 3 * (bundles.ends.size() / hair_lanes / 2));
}
