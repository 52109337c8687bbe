#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <span>
#include <vector>

#include "core/named.h"
#include "core/strands.h"

namespace ringlet {

/// Two edges of strands; an edge has the number of its first vertex. first < second.
struct EdgePair {
  int first, second;

  friend bool operator==(const EdgePair&, const EdgePair&) = default;
  friend auto operator<=>(const EdgePair&, const EdgePair&) = default;
};

/// Finds the pairs of edges that are near each other, whatever strands they belong to.
class ContactDetector : public Named {
 public:
  virtual ~ContactDetector() = default;

  /// Called once. The strands outlive the detector.
  virtual void bind(const Strands& strands) = 0;
  /// Replaces `pairs` by all pairs of edges nearer to each other than reach, m, at these positions
  /// of all vertices; but for edges that share a vertex. Sorted by first, then second, so that
  /// detectors differ in nothing but speed.
  virtual void find(std::span<const Eigen::Vector3d> positions, double reach,
                    std::vector<EdgePair>& pairs) = 0;
  /// The same, but only those of the pairs in which one of these edges is; sorted. Since the last
  /// call of either function, with the same reach, no vertices have moved but theirs: a detector
  /// may then have less to look at.
  virtual void find_with(std::span<const int> edges, std::span<const Eigen::Vector3d> positions,
                         double reach, std::vector<EdgePair>& pairs) {
    find(positions, reach, pairs);
    const auto is_one = [&](int edge) {
      return std::binary_search(edges.begin(), edges.end(), edge);
    };
    std::erase_if(
        pairs, [&](const EdgePair& pair) { return !is_one(pair.first) && !is_one(pair.second); });
  }
};

}  // namespace ringlet
