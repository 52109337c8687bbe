#include "collision/colliders/triangle_clusters.h"

#include <algorithm>
#include <numeric>
#include <span>

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

void split(const std::vector<SurfaceTriangle>& surface, std::span<int> triangles,
           std::vector<TriangleCluster>& clusters) {
  if (triangles.size() <= lane_count) {
    if (!triangles.empty()) clusters.push_back(make_cluster(surface, triangles));
    return;
  }
  BoundingBox centres;
  for (const int triangle : triangles) centres.extend(centre(surface[triangle]));
  int axis = 0;
  centres.sizes().maxCoeff(&axis);
  // A multiple of eight on one side keeps the clusters full.
  const std::size_t half = (triangles.size() / 2 + lane_count - 1) / lane_count * lane_count;
  std::nth_element(
      triangles.begin(), triangles.begin() + static_cast<std::ptrdiff_t>(half), triangles.end(),
      [&](int a, int b) { return centre(surface[a])[axis] < centre(surface[b])[axis]; });
  split(surface, triangles.first(half), clusters);
  split(surface, triangles.subspan(half), clusters);
}

}  // namespace

std::vector<TriangleCluster> cluster_triangles(const std::vector<SurfaceTriangle>& surface) {
  std::vector<int> triangles(surface.size());
  std::iota(triangles.begin(), triangles.end(), 0);
  std::vector<TriangleCluster> clusters;
  split(surface, triangles, clusters);
  return clusters;
}

}  // namespace ringlet
