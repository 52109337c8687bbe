#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <limits>

namespace ringlet {

/// What must be left of a distance: a part of what it is at first, or of a thickness, m, if that is
/// less.
struct KeptGap {
  double part;
  double thickness = std::numeric_limits<double>::infinity();

  double of(double distance) const { return std::max(0.0, part * std::min(distance, thickness)); }
};

/// What comes nearer than this part of its first distance has passed through.
inline constexpr double vanishing = 1e-6;

/// The largest part of a motion, at most 1, during which a distance stays above what must be left
/// of it (to a tenth), given that it changes by no more than `longest`, m, in the whole motion;
/// distance(part), m, is the distance, or less than it, at a part of the motion. Steps through the
/// motion by what the distance allows, as "Codimensional Incremental Potential Contact" does (Li,
/// Kaufman, Jiang, SIGGRAPH 2021, section 5): never too far, without roots of polynomials. 0 if the
/// distance is not above zero at first. ahead(part, left) may know better than `longest`: a later
/// part of the motion until which the distance, last asked for at `part`, stays above what is left.
template <class Distance, class Ahead>
double free_part(double longest, const KeptGap& kept, const Distance& distance,
                 const Ahead& ahead) {
  constexpr double careful = 0.9;
  double part = 0, gap = distance(0.0);
  const double floor = kept.of(gap);
  while (gap > floor) {
    // Always a little, even from just above the floor.
    const double used = careful * (gap - careful * floor);
    const double next = std::max(part + used / longest, ahead(part, gap - used));
    if (next >= 1) return 1;
    if (next == part) return part;
    part = next;
    gap = distance(part);
  }
  return part;
}
template <class Distance>
double free_part(double longest, const KeptGap& kept, const Distance& distance) {
  return free_part(longest, kept, distance, [](double part, double) { return part; });
}

/// The same for the distance of two segments whose four vertices move along straight lines.
double free_part_of_segments(const std::array<Eigen::Vector3d, 4>& from,
                             const std::array<Eigen::Vector3d, 4>& to, const KeptGap& kept);

}  // namespace ringlet
