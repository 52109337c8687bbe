#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <optional>

#include "collision/box_lanes.h"
#include "collision/detectors/growth.h"
#include "collision/edge_chunks.h"
#include "core/bytes.h"
#include "core/contact_detector.h"
#include "core/parallel.h"

namespace ringlet {

/// Boxes around the edges of all strands, which finds pairs of them that overlap: chunks of edges
/// in FCL's dynamic AABB tree, which is built once and then refitted, and of two chunks that
/// overlap the boxes of the edges one by one, side by side in lanes.
class EdgeBoxes {
 public:
  explicit EdgeBoxes(const Strands& strands);

  /// box_of(edge) is the box around an edge, which has the number of its first vertex: grown so
  /// that boxes overlap if what they hold is nearer than reach, m. Called from several threads at
  /// once.
  template <class BoxOf>
  void place(double reach, const BoxOf& box_of) {
    const Eigen::Vector3d origin = box_of(chunks_[0].first).min();
    parallel_for_each(static_cast<int>(chunks_.size()), [&](int c) {
      std::array<BoundingBox, BoxLanes::size> edges;
      BoundingBox all;
      for (int lane = 0; lane < chunks_[c].edges; ++lane) {
        edges[lane] = box_of(chunks_[c].first + lane);
        all.extend(edges[lane]);
      }
      const Eigen::Vector3d sides = Eigen::Vector3d::Constant(growth(all, reach));
      const auto grown = [&](const BoundingBox& box) {
        return BoundingBox(box.min() - sides, box.max() + sides);
      };
      boxes_[c] = grown(all);
      sides_[c].around = BoxSides::around(boxes_[c], origin);
      for (int lane = 0; lane < chunks_[c].edges; ++lane) {
        sides_[c].edges.set(lane, BoxSides::around(grown(edges[lane]), origin));
      }
    });
    refit();
  }

  /// The memory that they hold, without FCL's tree.
  std::size_t bytes() const { return bytes_of(chunks_) + bytes_of(boxes_) + bytes_of(sides_); }
  /// The search comes in parts, which threads can share. Each pair is found in one of them only.
  int part_count() const;
  /// visit(pair) for the overlapping pairs of a part, in no particular order; none of edges that
  /// share a vertex. Boxes that touch overlap, and so may ones that come as near as rounding to
  /// floats. Thread-safe.
  template <class Visit>
  void for_each_pair(int part, const Visit& visit) const {
    std::vector<BoxPair>& near = near_.local();
    find_chunks(part, near);
    for (const BoxPair& chunks : near) visit_pairs(chunks, visit);
  }

 private:
  /// Those of the edges of a chunk, and the one around them.
  struct Sides {
    BoxSides around;
    BoxLanes edges;
  };

  void refit();
  /// Replaces `found`.
  void find_chunks(int part, std::vector<BoxPair>& found) const;

  template <class Visit>
  void visit_pairs(const BoxPair& chunks, const Visit& visit) const {
    const Sides &a = sides_[chunks.first], &b = sides_[chunks.second];
    a.edges.for_each_overlapping(b.around, [&](int lane) {
      const int edge = chunks_[chunks.first].first + lane;
      b.edges.for_each_overlapping(a.edges.get(lane), [&](int other_lane) {
        const EdgePair pair{edge, chunks_[chunks.second].first + other_lane};
        if (pair.first + 1 < pair.second) visit(pair);
      });
    });
  }

  std::vector<EdgeChunk> chunks_;
  std::vector<BoundingBox> boxes_;  // of the chunks
  std::vector<Sides> sides_;        // of the chunks
  std::optional<BoxTree> tree_;
  mutable tbb::enumerable_thread_specific<std::vector<BoxPair>> near_;  // kept for the memory alone
};

}  // namespace ringlet
