#pragma once

#include <vector>

#include "collision/box_tree.h"
#include "collision/colliders/surface_normals.h"
#include "core/vector3.h"

namespace ringlet {

/// Neighbouring triangles side by side in lanes. Lanes without one repeat the first.
struct TriangleCluster {
  BoundingBox box;
  int first;                                ///< triangle; those of the other lanes come next
  Vector3<Pack> a;                          ///< a corner
  Vector3<Pack> ab, ac, bc;                 ///< edges
  Pack inverse_ab, inverse_ac, inverse_bc;  ///< 1 / squared length of each, 1/m^2
  Vector3<Pack> u, v;    ///< the foot of a perpendicular from p is a + u.(p - a) ab + v.(p - a) ac
  Vector3<Pack> normal;  ///< unit

  /// How a point lies to each of the triangles.
  struct Distances {
    Pack squared;   ///< m^2
    Pack height;    ///< above the plane of a triangle, m; negative below it
    Mask has_foot;  ///< whether the nearest point is the foot of a perpendicular
  };
  [[gnu::always_inline]] Distances distances(const Vector3<Pack>& point) const {
    const Vector3<Pack> r = point - a;
    const Pack to_ab = to_edge(r, ab, inverse_ab), to_ac = to_edge(r, ac, inverse_ac),
               to_bc = to_edge(r - ab, bc, inverse_bc);
    const Pack along_ab = dot(r, u), along_ac = dot(r, v), height = dot(r, normal);
    const Mask has_foot = along_ab > 0 && along_ac > 0 && along_ab + along_ac < 1;
    return {select(has_foot, height * height, min(min(to_ab, to_ac), to_bc)), height, has_foot};
  }

 private:
  [[gnu::always_inline]] static Pack to_edge(const Vector3<Pack>& r, const Vector3<Pack>& edge,
                                             const Pack& inverse) {
    const Pack along = min(max(dot(r, edge) * inverse, Pack(0)), Pack(1));
    return squared_norm(r - along * edge);
  }
};

/// Splits the triangles at medians of their centres until no part has more than one a lane, and
/// puts them into the order of these parts.
std::vector<TriangleCluster> cluster_triangles(std::vector<SurfaceTriangle>& surface);

}  // namespace ringlet
