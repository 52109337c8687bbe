#pragma once

#include <span>
#include <vector>

#include "collision/box_tree.h"
#include "core/strands.h"

namespace ringlet {

/// No chunk has more edges: so many that a box around them is worth its while, and whole packs.
inline constexpr int chunk_edges = 8;

/// Some consecutive edges of one strand, of about equal number all along the strand.
struct EdgeChunk {
  int first;     ///< its first edge, which has the number of its first vertex
  int edges;     ///< 1 to the most of a chunk
  int vertices;  ///< that it owns: those of its edges, but for the first of the next chunk
};

/// All edges of all strands, in order; most_edges: in a chunk.
std::vector<EdgeChunk> make_edge_chunks(const Strands& strands, int most_edges = chunk_edges);

/// The box around the edges of a chunk.
BoundingBox bounding_box(const EdgeChunk& chunk, std::span<const Eigen::Vector3d> positions);

}  // namespace ringlet
