#pragma once

#include <Eigen/Core>
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
};

}  // namespace ringlet
