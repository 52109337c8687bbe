#include "collision/colliders/nearest_triangle.h"

namespace ringlet {
namespace {

[[gnu::always_inline]] inline Pack outside(const Pack& low, const Pack& p, const Pack& high) {
  return max(max(low - p, p - high), Pack(0));
}

}  // namespace

NearestTriangle::NearestTriangle(const std::vector<TriangleCluster>& all, std::span<const int> near,
                                 double rounding)
    : all_(all), near_(near), boxes_((near.size() + lane_count - 1) / lane_count) {
  for (std::size_t n = 0; n < boxes_.size() * lane_count; ++n) {
    const BoundingBox& box = all[near[std::min(n, near.size() - 1)]].box;
    auto& [low, high] = boxes_[n / lane_count];
    const auto lane = static_cast<int>(n % lane_count);
    low.x[lane] = box.min().x() - rounding;
    low.y[lane] = box.min().y() - rounding;
    low.z[lane] = box.min().z() - rounding;
    high.x[lane] = box.max().x() + rounding;
    high.y[lane] = box.max().y() + rounding;
    high.z[lane] = box.max().z() + rounding;
  }
}

// Packs handed over to functions in memory would cost more than the sums, hence flatten.
[[gnu::flatten]] void NearestTriangle::look_into(int cluster, const Vector3<Pack>& point,
                                                 NearTriangle& best) {
  const TriangleCluster& triangles = all_[near_[cluster]];
  const TriangleCluster::Distances distances = triangles.distances(point);
  const double least = std::experimental::hmin(distances.squared);
  if (!(least <= best.squared_distance)) return;
  const int lane = std::experimental::find_first_set(distances.squared == Pack(least));
  const bool is_tie = least == best.squared_distance && best.triangle >= 0;
  if (is_tie && triangles.first + lane >= best.triangle) return;
  best = {least, triangles.first + lane, std::nullopt};
  if (distances.has_foot[lane]) {
    const auto& [x, y, z] = triangles.normal;
    best.above_face = {distances.height[lane], {x[lane], y[lane], z[lane]}};
  }
  likely_ = cluster;
}

[[gnu::flatten]] NearTriangle NearestTriangle::find(const Eigen::Vector3d& point, double reach) {
  NearTriangle best{reach * reach * (1 + 1e-12), -1, std::nullopt};
  if (near_.empty()) return best;
  const Vector3<Pack> p{Pack(point.x()), Pack(point.y()), Pack(point.z())};
  // Where the last point found its triangle, so that most others are too far away.
  const int first = likely_;
  look_into(first, p, best);
  for (std::size_t pack = 0; pack < boxes_.size(); ++pack) {
    const Pack bound =
        squared_norm(Vector3<Pack>{outside(boxes_[pack].low.x, p.x, boxes_[pack].high.x),
                                   outside(boxes_[pack].low.y, p.y, boxes_[pack].high.y),
                                   outside(boxes_[pack].low.z, p.z, boxes_[pack].high.z)});
    if (!any(bound <= best.squared_distance)) continue;
    for (int lane = 0; lane < lane_count; ++lane) {
      const int cluster = static_cast<int>(pack) * lane_count + lane;
      if (cluster == static_cast<int>(near_.size())) break;
      if (cluster != first && bound[lane] <= best.squared_distance) look_into(cluster, p, best);
    }
  }
  return best;
}

}  // namespace ringlet
