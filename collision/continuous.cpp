#include "collision/continuous.h"

#include <algorithm>
#include <cmath>

#include "collision/segment_distance.h"

namespace ringlet {

double free_part_of_segments(const std::array<Eigen::Vector3d, 4>& from,
                             const std::array<Eigen::Vector3d, 4>& to, const KeptGap& kept) {
  // What both have in common does not bring them nearer.
  std::array<Eigen::Vector3d, 4> motion;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (int i = 0; i < 4; ++i) {
    motion[i] = to[i] - from[i];
    mean += 0.25 * motion[i];
  }
  for (auto& m : motion) m -= mean;
  const double longest =
      std::max(motion[0].norm(), motion[1].norm()) + std::max(motion[2].norm(), motion[3].norm());
  const auto distance = [&](double part) {
    const auto at = [&](int i) { return from_eigen(from[i] + part * motion[i]); };
    return std::sqrt(closest_points(at(0), at(1), at(2), at(3)).squared_distance);
  };
  return free_part(longest, kept, distance);
}

}  // namespace ringlet
