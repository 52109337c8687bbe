// Near pairs of edges by FCL's dynamic AABB tree over chunks of edges. The tree is built for the
// rest shape and then refitted; it gives the chunks whose boxes come near. Then the boxes of the
// edges of one chunk are tested one by one against those of the other, side by side in lanes, and
// what is left edge by edge (pair_sieve.h).

#include <optional>

#include "collision/box_lanes.h"
#include "collision/detectors/growth.h"
#include "collision/detectors/pair_lists.h"
#include "collision/detectors/pair_sieve.h"
#include "collision/edge_chunks.h"
#include "core/parallel.h"
#include "core/registry.h"

namespace ringlet {
namespace {

constexpr int chunks_a_part = 256;

/// The grown boxes of the edges of a chunk and the box around them.
struct ChunkBoxes {
  int first;  // edge
  BoxSides around;
  BoxLanes edges;
};

class FclDetector final : public ContactDetector {
 public:
  void bind(const Strands& strands) override {
    chunks_ = make_edge_chunks(strands, BoxLanes::size);
    boxes_.resize(chunks_.size());
    sides_.resize(chunks_.size());
    std::vector<Eigen::Vector3d> at_rest;
    for (int v = 0; v < strands.vertex_count(); ++v) at_rest.push_back(strands.rest_position(v));
    place_chunks(at_rest, 0);
    tree_.emplace(boxes_);
  }

  void find(std::span<const Eigen::Vector3d> positions, double reach,
            std::vector<EdgePair>& pairs) override {
    place_chunks(positions, reach);
    tree_->refit(boxes_);
    const int chunk_count = static_cast<int>(chunks_.size());
    const int tree_parts = tree_->part_count();
    const int chunk_parts = (chunk_count + chunks_a_part - 1) / chunks_a_part;
    std::vector<std::vector<EdgePair>> found(tree_parts + chunk_parts);
    parallel_for_each(static_cast<int>(found.size()), [&](int part) {
      PairSieve sieve(positions, reach, found[part]);
      if (part < tree_parts) {
        std::vector<BoxPair> near;
        tree_->find_pairs(part, near);
        for (const BoxPair& chunks : near) find_in(chunks, sieve);
      } else {
        const int begin = (part - tree_parts) * chunks_a_part;
        const int end = std::min(begin + chunks_a_part, chunk_count);
        for (int c = begin; c < end; ++c) find_in({c, c}, sieve);
      }
      sieve.flush();
    });
    merge_sorted(found, pairs);
  }

 private:
  void place_chunks(std::span<const Eigen::Vector3d> positions, double reach) {
    parallel_for_each(static_cast<int>(chunks_.size()), [&](int c) {
      const EdgeChunk& chunk = chunks_[c];
      const BoundingBox box = bounding_box(chunk, positions);
      const Eigen::Vector3d sides = Eigen::Vector3d::Constant(growth(box, reach));
      boxes_[c] = BoundingBox(box.min() - sides, box.max() + sides);
      sides_[c].first = chunk.first;
      sides_[c].around = BoxSides::around(boxes_[c], positions[0]);
      const auto edge_box = [&](int lane) {
        if (lane >= chunk.edges) return BoxSides::none();
        const auto edge = positions.subspan(chunk.first + lane, 2);
        return BoxSides::around(
            {edge[0].cwiseMin(edge[1]) - sides, edge[0].cwiseMax(edge[1]) + sides}, positions[0]);
      };
      for (int lane = 0; lane < BoxLanes::size; ++lane) sides_[c].edges.set(lane, edge_box(lane));
    });
  }

  void find_in(const BoxPair& chunks, PairSieve& sieve) const {
    const ChunkBoxes &a = sides_[chunks.first], &b = sides_[chunks.second];
    a.edges.for_each_overlapping(b.around, [&](int lane) {
      const int edge = a.first + lane;
      b.edges.for_each_overlapping(a.edges.get(lane), [&](int other_lane) {
        const EdgePair pair{edge, b.first + other_lane};
        if (pair.first + 1 < pair.second) sieve.add(pair);
      });
    });
  }

  std::vector<EdgeChunk> chunks_;
  std::vector<BoundingBox> boxes_;  // of the chunks, grown
  std::vector<ChunkBoxes> sides_;
  std::optional<BoxTree> tree_;  // built at the rest shape
};

}  // namespace

void register_fcl_detector(Registry& registry);
void register_fcl_detector(Registry& registry) {
  registry.of<ContactDetector>().add<NoParameters>(
      "fcl", {"FCL's dynamic AABB tree over chunks of sixteen edges, refitted", "", ""},
      [](const NoParameters&) { return std::make_unique<FclDetector>(); });
}

}  // namespace ringlet
