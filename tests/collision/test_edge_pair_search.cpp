#include <algorithm>

#include "collision/edge_pair_search.h"
#include "collision/segment_distance.h"
#include "tests/catch.h"
#include "tests/collision/random_strands.h"

using namespace ringlet;

namespace {

bool before(const EdgePair& a, const EdgePair& b) {
  return a.first != b.first ? a.first < b.first : a.second < b.second;
}

std::vector<EdgePair> all_near_pairs(const Strands& strands, const ContactRule& rule,
                                     const Points& x, double reach) {
  std::vector<EdgePair> pairs;
  const auto is_edge = [&](int v) {
    return v + 1 < strands.vertex_count() && strands.strand_of(v) == strands.strand_of(v + 1);
  };
  for (int a = 0; a < strands.vertex_count(); ++a) {
    for (int b = a + 1; b < strands.vertex_count(); ++b) {
      if (!is_edge(a) || !is_edge(b) || !rule.allows({a, b})) continue;
      const auto near = closest_points(from_eigen(x[a]), from_eigen(x[a + 1]), from_eigen(x[b]),
                                       from_eigen(x[b + 1]));
      if (near.squared_distance < reach * reach) pairs.push_back({a, b});
    }
  }
  return pairs;
}

}  // namespace

TEST_CASE("edge pairs are those of brute force, also after the tree was refitted") {
  const unsigned seed = 5;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const Strands strands = random_bundle(random, 60);
  const auto chunks = make_edge_chunks(strands);
  const ContactRule rule(strands, 2e-3);
  const double reach = 1.5e-3;
  EdgePairSearch search(chunks, rule, reach);

  Points x = rest_positions(strands);
  for (int move = 0; move < 6; ++move) {
    auto found = search.find(x);
    std::sort(found.begin(), found.end(), before);
    CHECK(found.size() > 20);
    CHECK(found == all_near_pairs(strands, rule, x, reach));
    for (auto& p : x) p = 0.9 * p + random_point(random, 0.003);
    if (move == 3) std::reverse(x.begin(), x.end());  // nothing stays where the tree was built
  }
}

TEST_CASE("chunks cover every edge and own every vertex once") {
  std::mt19937 random(1);
  const Strands strands = random_bundle(random, 40);
  std::vector<int> edges(strands.vertex_count(), 0), vertices(strands.vertex_count(), 0);
  for (const EdgeChunk& chunk : make_edge_chunks(strands)) {
    CHECK((chunk.edges >= 1 && chunk.edges <= chunk_edges));
    for (int e = 0; e < chunk.edges; ++e) ++edges[chunk.first + e];
    for (int v = 0; v < chunk.vertices; ++v) ++vertices[chunk.first + v];
  }
  for (int v = 0; v < strands.vertex_count(); ++v) {
    const bool is_tip = v + 1 == strands.first(strands.strand_of(v) + 1);
    CHECK(edges[v] == (is_tip ? 0 : 1));
    CHECK(vertices[v] == 1);
  }
}

TEST_CASE("a single strand of one edge has no pairs") {
  const Strands strands({2}, {{0, 0, 0}, {1, 0, 0}}, Material{});
  const auto chunks = make_edge_chunks(strands);
  const ContactRule rule(strands, 0);
  CHECK(EdgePairSearch(chunks, rule, 1).find(rest_positions(strands)).empty());
}

TEST_CASE("edges of one strand need arc between them to be a contact") {
  const Strands strands(
      {6, 2},
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {5, 0, 0}, {0, 1, 0}, {1, 1, 0}},
      Material{});
  const ContactRule anything(strands, 0), far(strands, 1.5);
  CHECK_FALSE(anything.allows({0, 1}));  // they share a vertex
  CHECK(anything.allows({0, 2}));
  CHECK_FALSE(far.allows({0, 2}));  // 1 m apart
  CHECK(far.allows({0, 3}));        // 2 m apart
  CHECK(far.allows({4, 6}));        // of two strands
}

TEST_CASE("edges that cannot move are no contact") {
  const Strands strands({3, 3}, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}},
                        Material{});
  ContactRule rule(strands, 0);
  rule.set_free({false, false, true, false, false, true});
  CHECK_FALSE(rule.allows({0, 3}));
  CHECK(rule.allows({0, 4}));
  CHECK(rule.allows({1, 4}));
}
