#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "collision/box_tree.h"
#include "collision/contact_rule.h"
#include "collision/edge_chunks.h"
#include "core/vector3.h"

namespace ringlet {

/// Finds all pairs of edges that a rule allows and that are nearer to each other than a reach. FCL
/// finds the chunks of edges whose boxes come near; then the edges of one chunk are measured one by
/// one against those of the other, side by side in lanes.
class EdgePairSearch {
 public:
  /// The arguments by reference must outlive the search. reach: m.
  EdgePairSearch(const std::vector<EdgeChunk>& chunks, const ContactRule& rule, double reach)
      : chunks_(chunks), rule_(rule), reach_(reach) {}

  /// The pairs at these positions of all vertices, in an order that depends on nothing else.
  std::vector<EdgePair> find(std::span<const Eigen::Vector3d> positions);

 private:
  /// The edges of a chunk in lanes; lanes without an edge repeat the last.
  struct ChunkLanes {
    Vector3<Pack> start, end;
    Vector3<Pack> low, high;  ///< corners of the edges' boxes, grown by the reach
  };
  void place_chunks(std::span<const Eigen::Vector3d> positions);
  ChunkLanes lanes_of(const EdgeChunk& chunk, std::span<const Eigen::Vector3d> positions) const;
  std::vector<BoxPair> near_chunks() const;
  void find_in(const BoxPair& chunks, std::span<const Eigen::Vector3d> positions,
               std::vector<EdgePair>& found) const;

  const std::vector<EdgeChunk>& chunks_;
  const ContactRule& rule_;
  double reach_;
  std::vector<BoundingBox> boxes_;  // of the chunks, grown by half the reach
  std::vector<ChunkLanes> lanes_;
  std::optional<BoxTree> tree_;  // built at the first positions
};

}  // namespace ringlet
