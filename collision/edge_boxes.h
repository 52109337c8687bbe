#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <optional>

#include "collision/box_lanes.h"
#include "collision/detectors/growth.h"
#include "collision/edge_chunks.h"
#include "core/bytes.h"
#include "core/contact_detector.h"
#include "core/huge_pages.h"
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
    reach_ = reach;
    origin_ = box_of(chunks_[0].first).min();
    parallel_for_each(static_cast<int>(chunks_.size()), [&](int c) { place_chunk(c, box_of); });
    refit();
  }
  /// Places those of some edges, sorted, anew; box_of gives the boxes of the others as before.
  template <class BoxOf>
  void replace(std::span<const int> edges, const BoxOf& box_of) {
    for_each_chunk_of(edges, [&](int c, std::span<const int>) { place_chunk(c, box_of); });
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
  /// visit(pair) for the overlapping pairs in which one of some edges is, sorted; one of two such
  /// edges may be visited twice. box_of: as they were placed. Thread-safe.
  template <class BoxOf, class Visit>
  void for_each_pair_with(std::span<const int> edges, const BoxOf& box_of,
                          const Visit& visit) const {
    std::vector<int> near;
    for_each_chunk_of(edges, [&](int c, std::span<const int> edges_of_chunk) {
      BoundingBox all;
      for (const int edge : edges_of_chunk) all.extend(box_of(edge));
      near.clear();
      tree_->find_overlapping(grown(all, growth(all, reach_)), near);
      for (const int other : near) visit_pairs_of(c, edges_of_chunk, other, visit);
    });
  }

 private:
  /// Those of the edges of a chunk, and the one around them.
  struct Sides {
    BoxSides around;
    BoxLanes edges;
  };

  static BoundingBox grown(const BoundingBox& box, double by) {
    const Eigen::Vector3d sides = Eigen::Vector3d::Constant(by);
    return BoundingBox(box.min() - sides, box.max() + sides);
  }
  template <class BoxOf>
  void place_chunk(int c, const BoxOf& box_of) {
    std::array<BoundingBox, BoxLanes::size> edges;
    BoundingBox all;
    for (int lane = 0; lane < chunks_[c].edges; ++lane) {
      edges[lane] = box_of(chunks_[c].first + lane);
      all.extend(edges[lane]);
    }
    const double by = growth(all, reach_);
    boxes_[c] = grown(all, by);
    sides_[c].around = BoxSides::around(boxes_[c], origin_);
    for (int lane = 0; lane < chunks_[c].edges; ++lane) {
      sides_[c].edges.set(lane, BoxSides::around(grown(edges[lane], by), origin_));
    }
  }
  void refit();
  int chunk_of(int edge) const;
  /// body(chunk, those of its edges that are among some, sorted).
  template <class Body>
  void for_each_chunk_of(std::span<const int> edges, const Body& body) const {
    while (!edges.empty()) {
      const int c = chunk_of(edges[0]), end = chunks_[c].first + chunks_[c].edges;
      const auto count = std::lower_bound(edges.begin(), edges.end(), end) - edges.begin();
      body(c, edges.first(count));
      edges = edges.subspan(count);
    }
  }
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

  /// Those of some edges of a chunk with the edges of another one.
  template <class Visit>
  void visit_pairs_of(int c, std::span<const int> edges, int other, const Visit& visit) const {
    const Sides &a = sides_[c], &b = sides_[other];
    a.edges.for_each_overlapping(b.around, [&](int lane) {
      const int edge = chunks_[c].first + lane;
      if (!std::binary_search(edges.begin(), edges.end(), edge)) return;
      b.edges.for_each_overlapping(a.edges.get(lane), [&](int other_lane) {
        const int other_edge = chunks_[other].first + other_lane;
        const EdgePair pair{std::min(edge, other_edge), std::max(edge, other_edge)};
        if (pair.first + 1 < pair.second) visit(pair);
      });
    });
  }

  std::vector<EdgeChunk> chunks_;
  std::vector<BoundingBox> boxes_;  // of the chunks
  StreamedVector<Sides> sides_;     // of the chunks
  double reach_ = 0;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();  // from which lanes see boxes
  std::optional<BoxTree> tree_;
  mutable tbb::enumerable_thread_specific<std::vector<BoxPair>> near_;  // kept for the memory alone
};

}  // namespace ringlet
