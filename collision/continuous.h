#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>

namespace ringlet {

/// How much of a gap a step may use up, when it must not close.
inline constexpr double usable_part = 0.9;

/// The largest part of a motion, at most 1, during which a distance stays above a part of what it
/// is at first, given that it changes by no more than `longest`, m, in the whole motion;
/// distance(part), m, is the distance, or less than it, at a part of the motion. Steps through the
/// motion by what the distance allows, as "Codimensional Incremental Potential Contact" does (Li,
/// Kaufman, Jiang, SIGGRAPH 2021, section 5): never too far, without roots of polynomials. 0 if the
/// distance is not above zero at first.
template <class Distance>
double free_part(double longest, double kept_part, const Distance& distance) {
  double part = 0, gap = distance(0.0);
  const double floor = std::max(0.0, kept_part * gap);
  while (gap > floor) {
    // Always a little: where the gap is near the floor, it passes it in a few steps.
    const double advance = usable_part * gap;
    if (advance >= (1 - part) * longest) return 1;
    part += advance / longest;
    gap = distance(part);
  }
  return part;
}

/// The same for the distance of two segments whose four vertices move along straight lines.
double free_part_of_segments(const std::array<Eigen::Vector3d, 4>& from,
                             const std::array<Eigen::Vector3d, 4>& to, double kept_part);

}  // namespace ringlet
