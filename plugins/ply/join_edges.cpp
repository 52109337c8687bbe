#include "plugins/ply/join_edges.h"

namespace ringlet {
namespace {

constexpr int none = -1;

/// The vertices that edges join each vertex to.
using Neighbours = std::vector<VertexPair>;

std::optional<NoStrand> add_neighbour(Neighbours& neighbours, int vertex, int neighbour) {
  for (int& place : neighbours[static_cast<std::size_t>(vertex)]) {
    if (place != none) continue;
    place = neighbour;
    return {};
  }
  return NoStrand{vertex, "more than two edges meet there"};
}

bool is_end(const VertexPair& neighbours) { return neighbours[1] == none; }

}  // namespace

std::optional<NoStrand> join_edges(const std::vector<VertexPair>& edges, Polylines& vertices) {
  const std::size_t count = vertices.positions.size();
  Neighbours neighbours(count, {none, none});
  for (const auto& [a, b] : edges) {
    if (const auto problem = add_neighbour(neighbours, a, b)) return problem;
    if (const auto problem = add_neighbour(neighbours, b, a)) return problem;
  }
  Polylines joined;
  std::vector<bool> is_taken(count);
  for (std::size_t root = 0; root < count; ++root) {
    if (is_taken[root] || !is_end(neighbours[root])) continue;
    const std::size_t first = joined.positions.size();
    int before = none, next = static_cast<int>(root);
    while (next != none) {
      const auto v = static_cast<std::size_t>(next);
      is_taken[v] = true;
      joined.positions.push_back(vertices.positions[v]);
      if (!vertices.radii.empty()) joined.radii.push_back(vertices.radii[v]);
      const auto [a, b] = neighbours[v];
      next = a == before ? b : a;
      before = static_cast<int>(v);
    }
    joined.vertex_counts.push_back(static_cast<int>(joined.positions.size() - first));
  }
  for (std::size_t v = 0; v < count; ++v) {
    if (!is_taken[v]) return NoStrand{static_cast<int>(v), "its edges form a loop"};
  }
  vertices = std::move(joined);
  return {};
}

}  // namespace ringlet
