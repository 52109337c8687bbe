#pragma once

#include <optional>

#include "core/strands.h"

namespace ringlet {

/// The part of a strand that a pose may move.
struct FreePart {
  int root;    ///< first vertex of the strand
  int anchor;  ///< its last pinned vertex, or the root if none is pinned
  int first;   ///< first vertex that is free
  int end;     ///< one past the tip
};

/// Nothing if the whole strand is pinned.
std::optional<FreePart> free_part(const Strands& strands, const std::vector<int>& pinned_counts,
                                  int strand);

/// The unit axis of a strand from its anchor to its tip: the direction b of the straight line
/// a + b i that fits the rest positions best in the least squares, i counting the vertices. For a
/// straight strand its direction; for a curl nearer to the axis of the curl than the chord, which
/// ends anywhere on the last turn.
Eigen::Vector3d axis_of(const Strands& strands, const FreePart& part);

}  // namespace ringlet
