#include "collision/colliders/triangle_clusters.h"

#include <Eigen/Geometry>
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

void set_triangle(TriangleCluster& cluster, int lane,
                  const std::array<Eigen::Vector3d, 3>& corners) {
  const auto& [a, b, c] = corners;
  const Eigen::Vector3d ab = b - a, ac = c - a, bc = c - b, normal = ab.cross(ac);
  set_lane(cluster.a, lane, a);
  set_lane(cluster.ab, lane, ab);
  set_lane(cluster.ac, lane, ac);
  set_lane(cluster.bc, lane, bc);
  cluster.inverse_ab[lane] = 1 / ab.squaredNorm();
  cluster.inverse_ac[lane] = 1 / ac.squaredNorm();
  cluster.inverse_bc[lane] = 1 / bc.squaredNorm();
  set_lane(cluster.u, lane, ac.cross(normal) / normal.squaredNorm());
  set_lane(cluster.v, lane, normal.cross(ab) / normal.squaredNorm());
  set_lane(cluster.normal, lane, normal.normalized());
}

TriangleCluster make_cluster(int first, std::span<const SurfaceTriangle> triangles) {
  TriangleCluster cluster;
  cluster.first = first;
  for (std::size_t lane = 0; lane < lane_count; ++lane) {
    const auto& corners = triangles[lane < triangles.size() ? lane : 0].corners;
    set_triangle(cluster, static_cast<int>(lane), corners);
    for (const Eigen::Vector3d& corner : corners) cluster.box.extend(corner);
  }
  return cluster;
}

}  // namespace

std::vector<TriangleCluster> cluster_triangles(std::vector<SurfaceTriangle>& surface) {
  std::vector<Eigen::Vector3d> centres;
  for (const SurfaceTriangle& triangle : surface) centres.push_back(centre(triangle));
  std::vector<SurfaceTriangle> ordered;
  ordered.reserve(surface.size());
  std::vector<TriangleCluster> clusters;
  split_at_medians(centres, lane_count, [&](std::span<const int> triangles) {
    const std::size_t first = ordered.size();
    for (const int t : triangles) ordered.push_back(surface[t]);
    clusters.push_back(make_cluster(static_cast<int>(first), std::span(ordered).subspan(first)));
  });
  surface = std::move(ordered);
  return clusters;
}

}  // namespace ringlet
