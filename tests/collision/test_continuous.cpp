#include "collision/continuous.h"
#include "collision/segment_distance.h"
#include "collision/swept_pairs.h"
#include "tests/catch.h"
#include "tests/collision/random_strands.h"

using namespace ringlet;

namespace {

using Segments = std::array<Eigen::Vector3d, 4>;

Segments at_part(const Segments& from, const Segments& to, double part) {
  Segments at;
  for (int i = 0; i < 4; ++i) at[i] = (1 - part) * from[i] + part * to[i];
  return at;
}

/// Six times the volume between the segments, which changes its sign where their lines meet.
double volume(const Segments& at) {
  return (at[1] - at[0]).cross(at[3] - at[2]).dot(at[2] - at[0]);
}

/// Whether the segments meet on the way between two samples, in their insides.
bool meet(const Segments& before, const Segments& after) {
  const double v = volume(before), w = volume(after);
  if (v * w > 0) return false;
  const Segments at = at_part(before, after, v / (v - w));
  const auto [s, t, squared_distance] =
      closest_points(from_eigen(at[0]), from_eigen(at[1]), from_eigen(at[2]), from_eigen(at[3]));
  return s > 0.01 && s < 0.99 && t > 0.01 && t < 0.99;
}

double distance_at(const Segments& from, const Segments& to, double part) {
  const Segments at = at_part(from, to, part);
  return std::sqrt(
      closest_points(from_eigen(at[0]), from_eigen(at[1]), from_eigen(at[2]), from_eigen(at[3]))
          .squared_distance);
}

}  // namespace

TEST_CASE("two segments are free to move until they meet") {
  const Segments from{{{-1, 0, 0}, {1, 0, 0}, {0, -1, 0.5}, {0, 1, 0.5}}};
  Segments to = from;
  for (const int i : {2, 3}) to[i].z() = -0.5;
  CHECK(free_part_of_segments(from, to, {1e-9}) == Approx(0.5).epsilon(1e-6));
  // At first 0.5 apart; what must be left of that is left to a tenth.
  CHECK(free_part_of_segments(from, to, {0.2}) == Approx(0.4).margin(0.01));
  CHECK(free_part_of_segments(from, to, {0.2, 0.1}) == Approx(0.48).margin(0.002));
  CHECK(free_part_of_segments(from, to, {0.2, 7.0}) == free_part_of_segments(from, to, {0.2}));
  CHECK(free_part_of_segments(from, from, {1e-9}) == 1);
  CHECK(free_part_of_segments(to, to, {1}) == 0);
  Segments both_move = to;
  for (auto& p : both_move) p += Eigen::Vector3d(3, 4, 5);
  CHECK(free_part_of_segments(from, both_move, {1e-9}) == Approx(0.5).epsilon(1e-6));
  for (const int i : {2, 3}) to[i].z() = 0.01;
  CHECK(free_part_of_segments(from, to, {1e-9}) == 1);
}

TEST_CASE("segments that slide past each other are free at once, however near they are") {
  std::mt19937 random(57);
  for (int trial = 0; trial < 1000; ++trial) {
    const double gap = std::pow(10.0, -3 - trial % 8);
    const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), z = Eigen::Vector3d::UnitZ();
    const auto in_plane = [&] {
      Eigen::Vector3d p = random_point(random, 1);
      p.z() = 0;
      return p;
    };
    const Segments from{in_plane(), in_plane(), in_plane() + gap * z, in_plane() + gap * z};
    Segments to = from;
    for (auto& p : to) p += 0.1 * in_plane() + (&p < &to[2] ? 3.0 : 0.0) * x;
    CHECK(free_part_of_segments(from, to, {1e-6, gap}) == 1);
  }
}

TEST_CASE("within their free part, random segments stay apart") {
  const unsigned seed = 53;
  CAPTURE(seed);
  std::mt19937 random(seed);
  int blocked = 0;
  for (int trial = 0; trial < 300; ++trial) {
    Segments from, to;
    for (auto& p : from) p = random_point(random, 1);
    for (auto& p : to) p = random_point(random, 1);
    const double floor = 0.1 * distance_at(from, to, 0);
    const double part = free_part_of_segments(from, to, {0.1});
    if (part < 1) ++blocked;
    double least = 1;
    for (int i = 0; i <= 1000; ++i) least = std::min(least, distance_at(from, to, i * part / 1000));
    CHECK(least > 0);
    // Where nothing came near, nothing was blocked.
    double whole = 1;
    for (int i = 0; i <= 1000; ++i) whole = std::min(whole, distance_at(from, to, i / 1000.0));
    if (whole > 1.01 * floor) CHECK(part == 1);
  }
  CHECK(blocked > 20);
}

TEST_CASE("segments that pass through each other are never free to") {
  const unsigned seed = 71;
  CAPTURE(seed);
  std::mt19937 random(seed);
  constexpr int steps = 200;
  int passed = 0;
  // Rare are those whose closest points turn about each other where they meet.
  for (int trial = 0; trial < 8000; ++trial) {
    Segments from, to;
    for (auto& p : from) p = random_point(random, 1);
    for (auto& p : to) p = random_point(random, 1);
    int meetings = 0;
    for (int i = 0; i < steps; ++i) {
      if (!meet(at_part(from, to, 1.0 * i / steps), at_part(from, to, (i + 1.0) / steps))) continue;
      if (++meetings > 1) continue;
      const double part = free_part_of_segments(from, to, {1e-6});
      CHECK(part < (i + 1.0) / steps);
      CHECK(distance_at(from, to, part) < 1e-4);
    }
    if (meetings > 0) ++passed;
  }
  CHECK(passed > 500);
}

TEST_CASE("every pair of edges that comes near on the way is found") {
  std::mt19937 random(59);
  const Strands strands = random_bundle(random, 20);
  const ContactRule rule(strands, 2e-3);
  const Points from = rest_positions(strands);
  Points to;
  std::vector<Eigen::Vector3d> drift(strands.count());
  for (auto& d : drift) d = random_point(random, 5e-3);
  for (int v = 0; v < strands.vertex_count(); ++v)
    to.push_back(from[v] + drift[strands.strand_of(v)]);

  SweptPairs swept(strands);
  swept.find(to, from, 0, rule);  // the second search refits
  const std::vector<EdgePair> pairs = swept.find(from, to, 1e-3, rule);
  CHECK(std::is_sorted(pairs.begin(), pairs.end()));
  CHECK(std::adjacent_find(pairs.begin(), pairs.end()) == pairs.end());
  int near = 0;
  const auto is_edge = [&](int v) {
    return v + 1 < strands.vertex_count() && strands.strand_of(v) == strands.strand_of(v + 1);
  };
  for (int a = 0; a < strands.vertex_count(); ++a) {
    for (int b = a + 1; b < strands.vertex_count(); ++b) {
      if (!is_edge(a) || !is_edge(b) || !rule.allows({a, b})) continue;
      const Segments begin{from[a], from[a + 1], from[b], from[b + 1]};
      const Segments end{to[a], to[a + 1], to[b], to[b + 1]};
      bool comes_near = false;
      for (int i = 0; i <= 20; ++i) comes_near |= distance_at(begin, end, i / 20.0) < 1e-3;
      if (!comes_near) continue;
      ++near;
      CHECK(std::binary_search(pairs.begin(), pairs.end(), EdgePair{a, b}));
    }
  }
  CHECK(near > 10);
}
