#include "collision/edge_pair_search.h"

#include "collision/segment_distance.h"
#include "core/parallel.h"

namespace ringlet {
namespace {

Vector3<Pack> broadcast(const Eigen::Vector3d& a) {
  return {Pack(a.x()), Pack(a.y()), Pack(a.z())};
}

void set_lane(Vector3<Pack>& packs, int lane, const Eigen::Vector3d& a) {
  packs.x[lane] = a.x();
  packs.y[lane] = a.y();
  packs.z[lane] = a.z();
}

// Whether the interval between a and b meets that from low to high.
[[gnu::always_inline]] inline Mask overlap(const Pack& a, const Pack& b, const Pack& low,
                                           const Pack& high) {
  return max(a, b) >= low && min(a, b) <= high;
}

// A grain more than the reach, so that rounding loses no pair.
constexpr double grain = 1 + 1e-6;

}  // namespace

EdgePairSearch::ChunkLanes EdgePairSearch::lanes_of(
    const EdgeChunk& chunk, std::span<const Eigen::Vector3d> positions) const {
  const Eigen::Vector3d growth = Eigen::Vector3d::Constant(reach_ * grain);
  ChunkLanes lanes;
  for (int lane = 0; lane < lane_count; ++lane) {
    const int edge = chunk.first + std::min(lane, chunk.edges - 1);
    const Eigen::Vector3d &start = positions[edge], &end = positions[edge + 1];
    set_lane(lanes.start, lane, start);
    set_lane(lanes.end, lane, end);
    set_lane(lanes.low, lane, start.cwiseMin(end) - growth);
    set_lane(lanes.high, lane, start.cwiseMax(end) + growth);
  }
  return lanes;
}

void EdgePairSearch::place_chunks(std::span<const Eigen::Vector3d> positions) {
  boxes_.resize(chunks_.size());
  lanes_.resize(chunks_.size());
  // Two boxes grown by half the reach overlap if what they hold is that near.
  const Eigen::Vector3d growth = Eigen::Vector3d::Constant(0.5 * reach_ * grain);
  parallel_for_each(static_cast<int>(chunks_.size()), [&](int c) {
    const BoundingBox box = bounding_box(chunks_[c], positions);
    boxes_[c] = BoundingBox(box.min() - growth, box.max() + growth);
    lanes_[c] = lanes_of(chunks_[c], positions);
  });
}

std::vector<BoxPair> EdgePairSearch::near_chunks() const {
  std::vector<BoxPair> pairs = tree_->overlapping_pairs();
  for (int c = 0; c < static_cast<int>(chunks_.size()); ++c) pairs.push_back({c, c});
  return pairs;
}

void EdgePairSearch::find_in(const BoxPair& chunks, std::span<const Eigen::Vector3d> positions,
                             std::vector<EdgePair>& found) const {
  const EdgeChunk &a = chunks_[chunks.first], &b = chunks_[chunks.second];
  const ChunkLanes& lanes = lanes_[chunks.second];
  const double squared_reach = reach_ * reach_;
  for (int i = a.first; i < a.first + a.edges; ++i) {
    const Vector3<Pack> p0 = broadcast(positions[i]), p1 = broadcast(positions[i + 1]);
    const Mask boxes_overlap = overlap(p0.x, p1.x, lanes.low.x, lanes.high.x) &&
                               overlap(p0.y, p1.y, lanes.low.y, lanes.high.y) &&
                               overlap(p0.z, p1.z, lanes.low.z, lanes.high.z);
    if (!any(boxes_overlap)) continue;
    const Mask near =
        closest_points(p0, p1, lanes.start, lanes.end).squared_distance < squared_reach;
    if (!any(near)) continue;
    for (int lane = 0; lane < b.edges; ++lane) {
      const EdgePair pair{i, b.first + lane};
      if (near[lane] && pair.first < pair.second && rule_.allows(pair)) found.push_back(pair);
    }
  }
}

std::vector<EdgePair> EdgePairSearch::find(std::span<const Eigen::Vector3d> positions) {
  place_chunks(positions);
  if (tree_) {
    tree_->refit(boxes_);
  } else {
    tree_.emplace(boxes_);
  }
  const std::vector<BoxPair> near = near_chunks();

  constexpr int batch_size = 512;
  const int pair_count = static_cast<int>(near.size());
  std::vector<std::vector<EdgePair>> found((pair_count + batch_size - 1) / batch_size);
  parallel_for_each(static_cast<int>(found.size()), [&](int batch) {
    const int end = std::min(pair_count, (batch + 1) * batch_size);
    for (int p = batch * batch_size; p < end; ++p) find_in(near[p], positions, found[batch]);
  });
  std::vector<EdgePair> pairs;
  for (const auto& part : found) pairs.insert(pairs.end(), part.begin(), part.end());
  return pairs;
}

}  // namespace ringlet
