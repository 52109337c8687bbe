#include "collision/segment_distance.h"

namespace ringlet {

bool is_nearer(std::span<const Eigen::Vector3d> positions, const EdgePair& pair, double reach) {
  const auto vertex = [&](int v) { return from_eigen(positions[v]); };
  const auto proximity = closest_points(vertex(pair.first), vertex(pair.first + 1),
                                        vertex(pair.second), vertex(pair.second + 1));
  return proximity.squared_distance < reach * reach;
}

}  // namespace ringlet
