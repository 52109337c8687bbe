#include "collision/edge_chunks.h"
#include "tests/catch.h"
#include "tests/collision/random_strands.h"

using namespace ringlet;

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
