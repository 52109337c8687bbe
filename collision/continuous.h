#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>

namespace ringlet {

/// How much of a gap a step may use up, when it must not close.
inline constexpr double usable_part = 0.9;

/// The largest part of a motion, at most 1, during which a distance stays above `floor`, m, given
/// that it changes by no more than `longest`, m, in the whole motion; distance(part) is the
/// distance, or less than it, at a part of the motion. Steps through the motion by what the
/// distance allows, as "Codimensional Incremental Potential Contact" does (Li, Kaufman, Jiang,
/// SIGGRAPH 2021, section 5): never too far, without roots of polynomials. 0 if the distance starts
/// below the floor.
double free_part(double longest, double floor, const std::function<double(double)>& distance);

/// The same for the distance of two segments whose four vertices move along straight lines.
double free_part_of_segments(const std::array<Eigen::Vector3d, 4>& from,
                             const std::array<Eigen::Vector3d, 4>& to, double floor);

}  // namespace ringlet
