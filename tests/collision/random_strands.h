#pragma once

#include <random>
#include <vector>

#include "core/strands.h"

namespace ringlet {

using Points = std::vector<Eigen::Vector3d>;

inline Eigen::Vector3d random_point(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> coordinate(-size, size);
  return {coordinate(random), coordinate(random), coordinate(random)};
}

/// Strands of 2 to 30 vertices that wander about a cube of 4 cm.
inline Strands random_bundle(std::mt19937& random, int count) {
  std::vector<int> sizes;
  Points positions;
  for (int strand = 0; strand < count; ++strand) {
    sizes.push_back(std::uniform_int_distribution<int>(2, 30)(random));
    Eigen::Vector3d p = random_point(random, 0.02), heading = random_point(random, 0.002);
    for (int v = 0; v < sizes.back(); ++v) {
      positions.push_back(p);
      heading += random_point(random, 0.0005);
      p += heading;
    }
  }
  return Strands(sizes, positions, Material{});
}

inline Points rest_positions(const Strands& strands) {
  Points positions;
  for (int v = 0; v < strands.vertex_count(); ++v) positions.push_back(strands.rest_position(v));
  return positions;
}

}  // namespace ringlet
