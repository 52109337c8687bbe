#pragma once

#include <span>

#include "core/vector3.h"
#include "solvers/newton_iterations.h"

namespace ringlet {

/// trial = x - d for the rows of a group; returns what else follows from the direction d.
inline NewtonProblem::Direction follow_direction(std::span<const Vector3<Pack>> gradient,
                                                 std::span<const Vector3<Pack>> d,
                                                 std::span<const Vector3<Pack>> x,
                                                 std::span<Vector3<Pack>> trial) {
  Pack slope = 0, largest = 0;
  for (std::size_t i = 0; i < d.size(); ++i) {
    slope += dot(d[i], gradient[i]);
    largest = max(largest, squared_norm(d[i]));
    trial[i] = x[i] - d[i];
  }
  return {sum_lanes(slope), std::experimental::hmax(largest)};
}

/// Moves trial towards x, until their distance is so many times what it was.
inline void shorten(std::span<Vector3<Pack>> trial, std::span<const Vector3<Pack>> x,
                    double factor) {
  for (std::size_t i = 0; i < trial.size(); ++i) {
    trial[i] = x[i] + Pack(factor) * (trial[i] - x[i]);
  }
}

}  // namespace ringlet
