#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/strand_reader.h"

namespace ringlet {

using VertexPair = std::array<int, 2>;

/// A vertex that stands in the way of strands, and why.
struct NoStrand {
  int vertex;
  const char* reason;
};

/// Puts vertices in the order of the strands that edges make of them: a strand begins at that of
/// its ends which has the lower number, and strands go by their first vertices. A vertex without
/// an edge is a strand of its own. Fails where more than two edges meet, or where they form a loop.
std::optional<NoStrand> join_edges(const std::vector<VertexPair>& edges, Polylines& vertices);

}  // namespace ringlet
