#include "collision/colliders/triangle_clusters.h"

#include <algorithm>
#include <span>

#include "collision/median_split.h"

namespace ringlet {
namespace {

Eigen::Vector3d centre(const SurfaceTriangle& triangle) {
  return (triangle.corners[0] + triangle.corners[1] + triangle.corners[2]) / 3;
}

void set_lane(Vector3<Pack>& packs, int lane, const Eigen::Vector3d& p) {
  packs.x[lane] = p.x();
  packs.y[lane] = p.y();
  packs.z[lane] = p.z();
}

TriangleCluster make_cluster(const std::vector<SurfaceTriangle>& surface,
                             std::span<const int> triangles) {
  TriangleCluster cluster;
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    const int triangle = triangles[std::min(lane, triangles.size() - 1)];
    const auto& corners = surface[triangle].corners;
    cluster.triangles[lane] = triangle;
    set_lane(cluster.a, static_cast<int>(lane), corners[0]);
    set_lane(cluster.b, static_cast<int>(lane), corners[1]);
    set_lane(cluster.c, static_cast<int>(lane), corners[2]);
    for (const Eigen::Vector3d& corner : corners) cluster.box.extend(corner);
  }
  return cluster;
}

}  // namespace

std::vector<TriangleCluster> cluster_triangles(const std::vector<SurfaceTriangle>& surface) {
  std::vector<Eigen::Vector3d> centres;
  for (const SurfaceTriangle& triangle : surface) centres.push_back(centre(triangle));
  std::vector<TriangleCluster> clusters;
  split_at_medians(centres, lane_count, [&](std::span<const int> triangles) {
    clusters.push_back(make_cluster(surface, triangles));
  });
  return clusters;
}

}  // namespace ringlet
