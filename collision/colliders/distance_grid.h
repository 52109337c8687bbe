#pragma once

#include <array>
#include <optional>
#include <vector>

#include "collision/colliders/mesh_distance.h"

namespace ringlet {

/// Signed distances of a mesh at the nodes of a regular grid, kept only near the surface: in the
/// blocks of cells that come nearer to it than a band. Between nodes they are interpolated:
///
///     d(x) = sum_ijk w_i w_j w_k d_ijk,   normal = grad d / |grad d|
///
/// With cells of side h the error is below (k1 + k2) h^2 / 8 where the surface has the curvatures
/// k1, k2 as seen from x, nothing near a plane; and below sqrt(3)/2 h everywhere, edges and
/// vertices included, since a distance changes by no more than one moves.
struct DistanceGrid {
  static constexpr int block_cells = 8, block_side = block_cells + 1;
  static constexpr int block_nodes = block_side * block_side * block_side;

  double resolution = 0;  ///< side of a cell, m
  double band = 0;        ///< all is known nearer to the surface than this, m
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  std::array<int, 3> blocks{};   ///< along each axis
  std::vector<int> block_at;     ///< number of a block in `distances`, -1: none; x runs fastest
  std::vector<float> distances;  ///< m; the nodes of blocks, those that blocks share in each

  /// Distance and normal; nothing where no block is, which is further from the surface than the
  /// band.
  std::optional<Proximity> at(const Eigen::Vector3d& point) const;
};

/// Measures all nodes, in parallel. Throws Error, which says what resolution would do, if there are
/// too many blocks to number.
DistanceGrid make_distance_grid(const MeshDistance& mesh, double resolution, double band);

}  // namespace ringlet
