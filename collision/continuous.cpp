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
  Eigen::Vector3d apart = Eigen::Vector3d::Zero();  // from the second segment to the first
  const auto at = [&](int i, double part) -> Eigen::Vector3d { return from[i] + part * motion[i]; };
  const auto distance = [&](double part) {
    const Eigen::Vector3d p = at(0, part), d = at(1, part) - p, q = at(2, part),
                          e = at(3, part) - q;
    const auto [s, t, squared_distance] =
        closest_points(from_eigen(p), from_eigen(p + d), from_eigen(q), from_eigen(q + e));
    apart = (p + s * d) - (q + t * e);
    return std::sqrt(squared_distance);
  };
  // Along any direction the ends of the segments, which move linearly, bound their distance from
  // below. Edges that slide past each other, however near, need one step of this.
  const auto ahead = [&](double part, double left) {
    const Eigen::Vector3d direction = apart.normalized();
    double until = 1;
    for (const int i : {0, 1}) {
      for (const int j : {2, 3}) {
        const double gap = direction.dot(at(i, part) - at(j, part));
        const double rate = direction.dot(motion[i] - motion[j]);
        // Rounding has turned the direction too far for it to say anything.
        if (gap < left) return part;
        if (rate < 0) until = std::min(until, part + (gap - left) / -rate);
      }
    }
    return until;
  };
  return free_part(longest, kept, distance, ahead);
}

}  // namespace ringlet
