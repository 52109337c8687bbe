#include "core/poses/free_part.h"

#include <algorithm>

namespace ringlet {

std::optional<FreePart> free_part(const Strands& strands, const std::vector<int>& pinned_counts,
                                  int strand) {
  const int pinned = std::min(pinned_counts[strand], strands.size(strand));
  if (pinned == strands.size(strand)) return std::nullopt;
  const int root = strands.first(strand);
  return FreePart{root, root + std::max(pinned - 1, 0), root + pinned, strands.first(strand + 1)};
}

Eigen::Vector3d axis_of(const Strands& strands, const FreePart& part) {
  const double middle = 0.5 * (part.anchor + part.end - 1);
  Eigen::Vector3d slope = Eigen::Vector3d::Zero();
  for (int v = part.anchor; v < part.end; ++v) {
    slope += (v - middle) * (strands.rest_position(v) - strands.rest_position(part.anchor));
  }
  const Eigen::Vector3d first_edge =
      strands.rest_position(part.anchor + 1) - strands.rest_position(part.anchor);
  return (slope.stableNorm() > 0 ? slope : first_edge).stableNormalized();
}

}  // namespace ringlet
