// How far a step may go with the barrier, and what the barrier does not guard.

#include "collision/contact_rule.h"
#include "collision/continuous.h"
#include "collision/segment_distance.h"
#include "core/collision_stage.h"
#include "tests/catch.h"
#include "tests/collision/make_plugin.h"
#include "tests/collision/random_strands.h"

using namespace ringlet;

namespace {

/// Strands and a stage with a barrier bound to them.
struct Guarded {
  Strands strands;
  StrandGroups groups{strands};
  Motions motions;
  VertexField x;
  std::unique_ptr<CollisionStage> stage;

  Guarded(Strands given, const std::string& keys, int pinned = 0) : strands(std::move(given)) {
    stage = make_plugin<CollisionStage>(
        Json::parse(R"({"type": "fcl", "response": "barrier")" + keys + "}"));
    x = positions_with_pads(groups, rest_positions(strands));
    stage->bind(strands, groups, motions);
    VertexScalars free(groups.rows(), Pack(1));
    for (int v = 0; v < pinned; ++v) {
      const auto [row, lane] = groups.slot(v);
      free[row][lane] = 0;
    }
    stage->set_free(free);
    stage->begin_step(x, 0, 0.01);
    stage->detect(x);
  }
  Points positions() const {
    Points all;
    for (int v = 0; v < strands.vertex_count(); ++v) all.push_back(x.get(v));
    return all;
  }
  /// The limit of a step in which each vertex moves by this much.
  double limit(const Points& movement) {
    VertexField direction(groups);
    for (int v = 0; v < strands.vertex_count(); ++v) direction.set(v, -movement[v]);
    return stage->step_limit(x, direction);
  }
  bool is_edge(int v) const {
    return v + 1 < strands.vertex_count() && strands.strand_of(v) == strands.strand_of(v + 1);
  }
};

/// The same by asking every pair of edges.
double limit_of_all_pairs(const Guarded& guarded, const Points& movement, const KeptGap& kept) {
  const ContactRule rule(guarded.strands, 4e-3);
  const Points from = guarded.positions();
  double least = 1;
  for (int a = 0; a < guarded.strands.vertex_count(); ++a) {
    for (int b = a + 1; b < guarded.strands.vertex_count(); ++b) {
      if (!guarded.is_edge(a) || !guarded.is_edge(b) || !rule.allows({a, b})) continue;
      const std::array<int, 4> vertices{a, a + 1, b, b + 1};
      std::array<Eigen::Vector3d, 4> start, end;
      for (int i = 0; i < 4; ++i) {
        start[i] = from[vertices[i]];
        end[i] = start[i] + movement[vertices[i]];
      }
      least = std::min(least, free_part_of_segments(start, end, kept));
    }
  }
  return least;
}

/// Two strands of one edge each that cross a height h apart; the upper one falls by twice that.
Strands crossing_edges(double height) {
  return Strands({2, 2}, {{-1, 0, 0}, {1, 0, 0}, {0, -1, height}, {0, 1, height}}, Material{});
}

Points fall_of_upper(double by) { return {{0, 0, 0}, {0, 0, 0}, {0, 0, -by}, {0, 0, -by}}; }

}  // namespace

TEST_CASE("a step may go as far as all pairs of edges allow, however far others went before") {
  const unsigned seed = 67;
  CAPTURE(seed);
  std::mt19937 random(seed);
  Guarded guarded(random_bundle(random, 30), R"(, "thickness": 2e-3)");
  int limited = 0;
  // Small steps, for which candidates last; ones for which they are collected anew; and leaps.
  for (const double length :
       {1e-5, 1e-4, 2e-4, 4e-4, 1e-4, 1e-5, 2e-3, 1e-5, 1e-4, 8e-3, 4e-3, 3e-3, 1e-5}) {
    CAPTURE(length);
    guarded.stage->detect(guarded.x);
    Points movement(guarded.strands.vertex_count());
    for (auto& m : movement) m = random_point(random, length);
    const double part = guarded.limit(movement);
    CHECK(part >= limit_of_all_pairs(guarded, movement, {0.5, 2e-3}));
    CHECK(part <= limit_of_all_pairs(guarded, movement, {1e-9}));
    if (part < 1) ++limited;
    for (int v = 0; v < guarded.strands.vertex_count(); ++v) {
      guarded.x.add(v, part * movement[v]);
    }
  }
  CHECK(limited > 3);
}

TEST_CASE(
    "a common motion of all strands is reached at once, one of a single strand not through "
    "another") {
  const Eigen::Isometry3d turn(Eigen::Translation3d(0.1, 0, 0) *
                               Eigen::AngleAxisd(2, Eigen::Vector3d::UnitZ()));
  for (const double fall : {0.0, 0.05, 0.2}) {
    CAPTURE(fall);
    Guarded guarded(crossing_edges(0.1), R"(, "thickness": 0.02)");
    VertexField guess = guarded.x;
    const Points own = fall_of_upper(fall);
    for (int v = 0; v < 4; ++v) guess.set(v, turn * (guarded.x.get(v) + own[v]));
    guarded.stage->begin_step(guarded.x, 0.01, 0.01);
    CHECK(guarded.stage->can_reach(guarded.x, guess) == (fall < 0.1));
  }
}

TEST_CASE("edges of two strands keep half of what they have of the thickness between them") {
  for (const double height : {0.03, 0.1}) {
    CAPTURE(height);
    Guarded guarded(crossing_edges(height), R"(, "thickness": 0.02)");
    const double left = height - 2 * height * guarded.limit(fall_of_upper(2 * height));
    CHECK(left <= 0.01);
    CHECK(left >= 0.009);
  }
}

TEST_CASE("a barrier holds pairs that are near at rest as strongly as any other") {
  // E(h/2) = k H h ln(2) / 8, with the thickness H and the one of the pair, h.
  for (const double at_rest : {1e-5, 1e-3, 0.015, 0.1}) {
    CAPTURE(at_rest);
    const double own = at_rest < 0.02 ? 0.9 * at_rest : 0.02;  // without the slack
    Guarded guarded(crossing_edges(at_rest), R"(, "thickness": 0.02, "stiffness": 3)");
    for (const int v : {2, 3}) guarded.x.add(v, {0, 0, own / 2 - at_rest});
    guarded.stage->detect(guarded.x);
    const double energy = 3 * 0.02 * own * std::log(2) / 8;
    CHECK(guarded.stage->add(guarded.x, nullptr) == Approx(energy).epsilon(1e-4));
  }
}

TEST_CASE("edges all of whose vertices are pinned are not guarded") {
  Guarded guarded(crossing_edges(0.01), R"(, "thickness": 0.02)", 4);
  CHECK(guarded.limit(fall_of_upper(0.02)) == 1);
}

TEST_CASE("edges that cross at rest are not guarded") {
  const double rounding = GENERATE(0.0, 1e-9);
  Guarded guarded(crossing_edges(rounding), R"(, "thickness": 0.02)");
  for (const int v : {2, 3}) guarded.x.add(v, {0, 0, 0.01});
  guarded.stage->detect(guarded.x);
  CHECK(guarded.limit(fall_of_upper(0.02)) == 1);
}

TEST_CASE("edges that are near at rest and may come as near as they like are not guarded") {
  for (const double slack : {0.5, 1.0}) {
    Guarded guarded(crossing_edges(0.01),
                    R"(, "thickness": 0.02, "rest_slack": )" + std::to_string(slack));
    CHECK((guarded.limit(fall_of_upper(0.02)) == 1) == (slack == 1));
  }
}

TEST_CASE("edges of one strand with less than the arc distance between them are not guarded") {
  // A hairpin: the last edge lies above the first and falls through it.
  const Points hairpin{{-1, 0, 0}, {1, 0, 0}, {1, 0, 0.01}, {0, -1, 0.01}, {0, 1, 0.01}};
  Points fall(5, Eigen::Vector3d::Zero());
  for (const int v : {3, 4}) fall[v].z() = -0.02;
  const double arc = 0.01 + std::sqrt(2.0);
  for (const double arc_distance : {0.9 * arc, 1.1 * arc}) {
    CAPTURE(arc_distance);
    Guarded guarded(Strands({5}, hairpin, Material{}),
                    R"(, "thickness": 0.02, "arc_distance": )" + std::to_string(arc_distance));
    CHECK((guarded.limit(fall) == 1) == (arc_distance > arc));
  }
}
