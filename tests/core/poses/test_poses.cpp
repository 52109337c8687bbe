#include <Eigen/Geometry>
#include <numbers>

#include "core/pose.h"
#include "core/strand_source.h"
#include "tests/catch.h"
#include "tests/core/read_plugin.h"

using namespace ringlet;

namespace {

// Three curls of different roots and lengths: the first pinned at four vertices, the second not at
// all, the third wholly.
struct Curls {
  StrandSet set;
  Strands strands;

  Curls() : set(generate()), strands(set.vertex_counts, set.positions, Material{}) {}

  static StrandSet generate() {
    StrandSet set;
    for (const auto& [vertices, pinned] : {std::pair{50, 4}, {30, 0}, {5, 5}}) {
      const Json json{{"type", "helix"},
                      {"vertices", vertices},
                      {"roots", {{"type", "point"}, {"position", {vertices, 1, 0}}}}};
      const StrandSet one = make_plugin<StrandSource>(json)->generate();
      set.vertex_counts.push_back(vertices);
      set.pinned_counts.push_back(pinned);
      set.motions.emplace_back();
      set.positions.insert(set.positions.end(), one.positions.begin(), one.positions.end());
    }
    return set;
  }

  std::vector<Eigen::Vector3d> posed(const Json& json) const {
    auto positions = set.positions;
    make_plugin<Pose>(json)->apply(strands, set.pinned_counts, positions);
    return positions;
  }
  bool is_pinned(int v) const {
    const int strand = strands.strand_of(v);
    return v - strands.first(strand) < set.pinned_counts[strand];
  }
};

const std::vector<Json> all_poses = {{{"type", "scale"}, {"factors", {0.4, 1, 1.5}}},
                                     {{"type", "jitter"}, {"amplitude", 0.005}},
                                     {{"type", "straighten"}},
                                     {{"type", "compress"}, {"fraction", 0.4}},
                                     {{"type", "twist_end"}}};

}  // namespace

TEST_CASE("poses move free vertices and leave pinned ones in place") {
  const Curls curls;
  for (const Json& json : all_poses) {
    CAPTURE(json);
    const auto x = curls.posed(json);
    bool moved_first = false, moved_second = false;
    for (int v = 0; v < curls.strands.vertex_count(); ++v) {
      REQUIRE(x[v].allFinite());
      const bool moved = x[v] != curls.set.positions[v];
      if (curls.is_pinned(v)) CHECK_FALSE(moved);
      if (moved && curls.strands.strand_of(v) == 0) moved_first = true;
      if (moved && curls.strands.strand_of(v) == 1) moved_second = true;
    }
    CHECK(moved_first);
    CHECK(moved_second);
  }
}

TEST_CASE("scale multiplies the offset from the root") {
  const Curls curls;
  const auto x = curls.posed(all_poses[0]);
  for (const int v : {4, 20, 49}) {
    const Eigen::Vector3d before = curls.set.positions[v] - curls.set.positions[0];
    const Eigen::Vector3d after = x[v] - curls.set.positions[0];
    CHECK(after.isApprox(Eigen::Vector3d(0.4 * before.x(), before.y(), 1.5 * before.z())));
  }
  CHECK(x[50] == curls.set.positions[50]);  // the root of a strand that is not pinned
}

TEST_CASE("jitter stays within its amplitude, fills it, and follows its seed") {
  const Curls curls;
  const auto x = curls.posed(all_poses[1]);
  CHECK(curls.posed(all_poses[1]) == x);
  CHECK(curls.posed({{"type", "jitter"}, {"amplitude", 0.005}, {"seed", 2}}) != x);
  double largest = 0, sum = 0;
  for (int v = 0; v < curls.strands.vertex_count(); ++v) {
    const Eigen::Vector3d offset = x[v] - curls.set.positions[v];
    largest = std::max(largest, offset.cwiseAbs().maxCoeff());
    sum += offset.sum();
  }
  CHECK(largest <= 0.005 + 1e-12);
  CHECK(largest > 0.0045);
  CHECK(std::abs(sum) / (76 * 3) < 0.001);
}

TEST_CASE("straighten makes a straight line of rest length from the last pinned vertex") {
  const Curls curls;
  const auto x = curls.posed({{"type", "straighten"}});
  for (const auto& [anchor, tip] : {std::pair{3, 49}, {50, 79}}) {
    const Eigen::Vector3d axis = (x[tip] - x[anchor]).normalized();
    CHECK(axis.y() > 0.98);  // the axis of the curl, up to what its last, broken turn tilts
    for (int v = anchor; v < tip; ++v) {
      CHECK((x[v + 1] - x[v]).norm() == Approx(curls.strands.rest_length(v)));
      CHECK((x[v + 1] - x[v]).cross(axis).norm() < 1e-13);
    }
  }
}

TEST_CASE("compress takes its fraction off the height and nothing off the width") {
  const Json json{{"type", "line"}, {"vertices", 11}, {"length", 1}};
  const StrandSet set = make_plugin<StrandSource>(json)->generate();
  const Strands line(set.vertex_counts, set.positions, Material{});
  auto x = set.positions;
  x[10].x() = 0.5;  // the axis is that of the rest shape
  make_plugin<Pose>({{"type", "compress"}, {"fraction", 0.3}})->apply(line, {2}, x);
  CHECK(x[10].y() == Approx(0.1 + 0.7 * 0.9));
  CHECK(x[10].x() == Approx(0.5));
}

TEST_CASE("twist_end turns the tip about the edge before it and nothing else") {
  const Curls curls;
  const auto& rest = curls.set.positions;
  const auto x = curls.posed({{"type", "twist_end"}});
  for (int v = 0; v < 49; ++v) CHECK(x[v] == rest[v]);
  const Eigen::Vector3d edge = (rest[48] - rest[47]).normalized();
  const Eigen::Vector3d before = (rest[49] - rest[48]).cross(edge);
  const Eigen::Vector3d after = (x[49] - rest[48]).cross(edge);
  CHECK((x[49] - rest[48]).norm() == Approx((rest[49] - rest[48]).norm()));
  CHECK((x[49] - rest[48]).dot(edge) == Approx((rest[49] - rest[48]).dot(edge)));
  CHECK(std::atan2(edge.dot(before.cross(after)), before.dot(after)) ==
        Approx(std::numbers::pi / 4));
}

TEST_CASE("positions are taken as they are, but for pinned vertices") {
  const Curls curls;
  Json strands = Json::array();
  for (int s = 0; s < 3; ++s) {
    strands.push_back(Json::array());
    for (int i = 0; i < curls.strands.size(s); ++i) strands[s].push_back({s, i, 7});
  }
  const auto x = curls.posed({{"type", "positions"}, {"strands", strands}});
  for (int s = 0; s < 3; ++s) {
    for (int i = 0; i < curls.strands.size(s); ++i) {
      const int v = curls.strands.first(s) + i;
      const bool is_pinned = i < curls.set.pinned_counts[s];
      CHECK(x[v] == (is_pinned ? curls.strands.rest_position(v) : Eigen::Vector3d(s, i, 7)));
    }
  }
  strands[1].erase(4);
  CHECK_THROWS_WITH(curls.posed({{"type", "positions"}, {"strands", strands}}),
                    "strand 1: expected 30 positions, found 29");
  strands.erase(0);
  CHECK_THROWS_WITH(curls.posed({{"type", "positions"}, {"strands", strands}}),
                    "expected the positions of 3 strands, found those of 2");
}

TEST_CASE("a strand of two vertices, a ring and a wholly pinned strand pass through all poses") {
  std::vector<Eigen::Vector3d> rest = {{0, 0, 0}, {0, 0, 1}};
  for (int i = 0; i <= 8; ++i) {
    rest.emplace_back(std::cos(i * std::numbers::pi / 4), std::sin(i * std::numbers::pi / 4), 0);
  }
  const Strands strands({2, 9}, rest, Material{});
  for (const Json& json : all_poses) {
    for (const std::vector<int>& pinned : {std::vector{0, 0}, {1, 1}, {2, 9}, {7, 99}}) {
      auto x = rest;
      make_plugin<Pose>(json)->apply(strands, pinned, x);
      for (const auto& position : x) CHECK(position.allFinite());
      if (pinned[0] >= 2) CHECK(x == rest);
    }
  }
}

TEST_CASE("bad parameters of poses are reported") {
  CHECK(read_plugin<Pose>("scale").has_one_problem("/factors", "missing"));
  CHECK(read_plugin<Pose>({{"type", "scale"}, {"factors", 2}}).has_one_problem("/factors", "list"));
  CHECK(read_plugin<Pose>({{"type", "jitter"}, {"amplitude", -1}})
            .has_one_problem("/amplitude", ">= 0 in m"));
  CHECK(read_plugin<Pose>({{"type", "compress"}, {"fraction", 1.5}})
            .has_one_problem("/fraction", "in [0, 1]"));
  CHECK(read_plugin<Pose>({{"type", "twist_end"}, {"angle", "45"}})
            .has_one_problem("/angle", "in rad"));
  CHECK(read_plugin<Pose>({{"type", "straighten"}, {"angle", 1}})
            .has_one_problem("/angle", "unknown key"));
}
