// Near pairs of edges by FCL's dynamic AABB tree over chunks of edges. The tree is built for the
// rest shape and then refitted; it gives the chunks whose boxes come near. Then the edges of one
// chunk are measured one by one against those of the other, side by side in lanes.

#include <optional>

#include "collision/detectors/coordinate_arrays.h"
#include "collision/detectors/growth.h"
#include "collision/detectors/pair_lists.h"
#include "collision/edge_chunks.h"
#include "collision/segment_distance.h"
#include "core/parallel.h"
#include "core/registry.h"

namespace ringlet {
namespace {

constexpr int chunks_a_part = 256;

Vector3<Pack> broadcast(const Vector3<double>& a) { return {Pack(a.x), Pack(a.y), Pack(a.z)}; }

/// An interval of one coordinate, in lanes.
struct Interval {
  Pack low, high;
};

[[gnu::always_inline]] inline Interval interval(const Pack& a, const Pack& b, double growth) {
  return {min(a, b) - growth, max(a, b) + growth};
}

[[gnu::always_inline]] inline Mask overlap(const Interval& a, const Interval& b) {
  return a.low <= b.high && b.low <= a.high;
}

class FclDetector final : public ContactDetector {
 public:
  void bind(const Strands& strands) override {
    chunks_ = make_edge_chunks(strands);
    boxes_.resize(chunks_.size());
    growths_.resize(chunks_.size());
    std::vector<Eigen::Vector3d> at_rest;
    for (int v = 0; v < strands.vertex_count(); ++v) at_rest.push_back(strands.rest_position(v));
    place_chunks(at_rest, 0);
    tree_.emplace(boxes_);
  }

  void find(std::span<const Eigen::Vector3d> positions, double reach,
            std::vector<EdgePair>& pairs) override {
    place_chunks(positions, reach);
    tree_->refit(boxes_);
    const Search search{positions, reach};
    const int chunk_count = static_cast<int>(chunks_.size());
    const int tree_parts = tree_->part_count();
    const int chunk_parts = (chunk_count + chunks_a_part - 1) / chunks_a_part;
    std::vector<std::vector<EdgePair>> found(tree_parts + chunk_parts);
    parallel_for_each(static_cast<int>(found.size()), [&](int part) {
      if (part < tree_parts) {
        std::vector<BoxPair> near;
        tree_->find_pairs(part, near);
        for (const BoxPair& chunks : near) find_in(chunks, search, found[part]);
      } else {
        const int begin = (part - tree_parts) * chunks_a_part;
        const int end = std::min(begin + chunks_a_part, chunk_count);
        for (int c = begin; c < end; ++c) find_in({c, c}, search, found[part]);
      }
    });
    merge_sorted(found, pairs);
  }

 private:
  struct Search {
    std::span<const Eigen::Vector3d> positions;
    double reach;
  };

  void place_chunks(std::span<const Eigen::Vector3d> positions, double reach) {
    coordinates_.set(positions);
    parallel_for_each(static_cast<int>(chunks_.size()), [&](int c) {
      const BoundingBox box = bounding_box(chunks_[c], positions);
      growths_[c] = growth(box, reach);
      const Eigen::Vector3d sides = Eigen::Vector3d::Constant(growths_[c]);
      boxes_[c] = BoundingBox(box.min() - sides, box.max() + sides);
    });
  }

  void find_in(const BoxPair& chunks, const Search& search, std::vector<EdgePair>& found) const {
    const EdgeChunk& a = chunks_[chunks.first];
    const BoundingBox& box = boxes_[chunks.second];
    const auto side = [&](int axis) { return Interval{box.min()[axis], box.max()[axis]}; };
    const Interval x = side(0), y = side(1), z = side(2);
    const double growth = growths_[chunks.first];
    for (int first = 0; first < a.edges; first += lane_count) {
      const Vector3<Pack> p0 = coordinates_.lanes(a.first + first);
      const Vector3<Pack> p1 = coordinates_.lanes(a.first + first + 1);
      const Mask near = overlap(interval(p0.x, p1.x, growth), x) &&
                        overlap(interval(p0.y, p1.y, growth), y) &&
                        overlap(interval(p0.z, p1.z, growth), z);
      if (!any(near)) continue;
      for (int lane = 0; lane < std::min(lane_count, a.edges - first); ++lane) {
        if (near[lane]) find_near(a.first + first + lane, chunks, search, found);
      }
    }
  }

  // Of the pairs of one edge of the first chunk with those of the second.
  void find_near(int edge, const BoxPair& chunks, const Search& search,
                 std::vector<EdgePair>& found) const {
    const EdgeChunk& b = chunks_[chunks.second];
    const double reach = growths_[chunks.first] + growths_[chunks.second];
    const Vector3<Pack> p0 = broadcast(coordinates_.get(edge));
    const Vector3<Pack> p1 = broadcast(coordinates_.get(edge + 1));
    const Interval x = interval(p0.x, p1.x, reach), y = interval(p0.y, p1.y, reach),
                   z = interval(p0.z, p1.z, reach);
    for (int first = 0; first < b.edges; first += lane_count) {
      const Vector3<Pack> q0 = coordinates_.lanes(b.first + first);
      const Vector3<Pack> q1 = coordinates_.lanes(b.first + first + 1);
      if (!any(overlap(interval(q0.x, q1.x, 0), x) && overlap(interval(q0.y, q1.y, 0), y) &&
               overlap(interval(q0.z, q1.z, 0), z))) {
        continue;
      }
      const Mask near = closest_points(p0, p1, q0, q1).squared_distance < reach * reach;
      if (!any(near)) continue;
      for (int lane = 0; lane < std::min(lane_count, b.edges - first); ++lane) {
        const EdgePair pair{edge, b.first + first + lane};
        if (near[lane] && pair.first + 1 < pair.second &&
            is_nearer(search.positions, pair, search.reach)) {
          found.push_back(pair);
        }
      }
    }
  }

  std::vector<EdgeChunk> chunks_;
  CoordinateArrays coordinates_;
  std::vector<BoundingBox> boxes_;  // of the chunks, grown
  std::vector<double> growths_;
  std::optional<BoxTree> tree_;  // built at the rest shape
};

}  // namespace

void register_fcl_detector(Registry& registry);
void register_fcl_detector(Registry& registry) {
  registry.of<ContactDetector>().add<NoParameters>(
      "fcl", {"FCL's dynamic AABB tree over chunks of eight edges, refitted", "", ""},
      [](const NoParameters&) { return std::make_unique<FclDetector>(); });
}

}  // namespace ringlet
