#pragma once

#include "collision/segment_distance.h"

namespace ringlet {

/// What a contact detector has to find, by looking at all pairs one by one.
inline std::vector<EdgePair> all_near_pairs(const Strands& strands,
                                            std::span<const Eigen::Vector3d> x, double reach) {
  std::vector<EdgePair> pairs;
  const auto is_edge = [&](int v) {
    return v + 1 < strands.vertex_count() && strands.strand_of(v) == strands.strand_of(v + 1);
  };
  for (int a = 0; a < strands.vertex_count(); ++a) {
    if (!is_edge(a)) continue;
    for (int b = a + 2; b < strands.vertex_count(); ++b) {
      if (is_edge(b) && is_nearer(x, {a, b}, reach)) pairs.push_back({a, b});
    }
  }
  return pairs;
}

}  // namespace ringlet
