#pragma once

#include <span>
#include <vector>

#include "collision/contact_rule.h"
#include "collision/edge_boxes.h"

namespace ringlet {

/// Finds pairs of edges whose ways, as all vertices move along straight lines, may come near each
/// other.
class SweptPairs {
 public:
  explicit SweptPairs(const Strands& strands) : boxes_(strands) {}

  /// Every allowed pair that comes nearer than reach, m, on the way, and others; sorted.
  std::vector<EdgePair> find(std::span<const Eigen::Vector3d> from,
                             std::span<const Eigen::Vector3d> to, double reach,
                             const ContactRule& rule);

  std::size_t bytes() const { return boxes_.bytes(); }

 private:
  EdgeBoxes boxes_;  // around the ways of edges
};

}  // namespace ringlet
