#pragma once

#include <optional>
#include <span>
#include <vector>

#include "collision/box_tree.h"
#include "collision/contact_rule.h"
#include "collision/edge_chunks.h"

namespace ringlet {

/// Finds pairs of edges whose ways, as all vertices move along straight lines, may come near each
/// other.
class SweptPairs {
 public:
  /// The chunks outlive this.
  explicit SweptPairs(const std::vector<EdgeChunk>& chunks) : chunks_(chunks) {}

  /// Every allowed pair that comes nearer than reach, m, on the way, and others; sorted.
  std::vector<EdgePair> find(std::span<const Eigen::Vector3d> from,
                             std::span<const Eigen::Vector3d> to, double reach,
                             const ContactRule& rule);

 private:
  void sweep(std::span<const Eigen::Vector3d> from, std::span<const Eigen::Vector3d> to,
             double reach);
  void add_near_edges(const BoxPair& chunks, const ContactRule& rule,
                      std::vector<EdgePair>& pairs) const;

  const std::vector<EdgeChunk>& chunks_;
  std::optional<BoxTree> tree_;
  std::vector<BoundingBox> edges_, boxes_;  // around the ways of edges, of chunks
};

}  // namespace ringlet
