#pragma once

#include "core/strand_reader.h"

namespace ringlet {

/// What merge_short_edges did.
struct MergeReport {
  double minimum_edge = 0;  ///< the shortest edge that was allowed
  int merged_vertices = 0;  ///< vertices left out of strands that stay
  int dropped_strands = 0;  ///< strands that had, or kept, fewer than two vertices
};

/// The median length of all edges; 0 if there is none.
double median_edge(const Polylines& polylines);

/// Merges every vertex that is no further than minimum_edge from the one kept before it into that
/// one, from the root on, and drops strands of fewer than two vertices. Afterwards every edge is
/// longer than minimum_edge, so that with 0 only coinciding vertices go; a strand may lose up to
/// minimum_edge at its tip. Radii are dropped: those of a simulation are its material's.
MergeReport merge_short_edges(Polylines& polylines, double minimum_edge);

}  // namespace ringlet
