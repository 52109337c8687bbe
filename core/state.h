#pragma once

#include <vector>

#include "core/vertex_field.h"

namespace ringlet {

/// What an integrator knows of the steps before.
struct StepHistory {
  double dt = 0;                    ///< length of the last step, s; 0: there was none
  std::vector<VertexField> fields;  ///< as the integrator says
  /// Of each group of strands, for how many steps it has been at rest; empty where nobody sleeps.
  std::vector<int> still_steps;

  std::size_t bytes() const {
    std::size_t sum = bytes_of(still_steps);
    for (const VertexField& field : fields) sum += field.bytes();
    return sum;
  }
};

/// The state of a simulation: time, positions and velocities of all vertices.
struct State {
  double time = 0;           ///< s
  VertexField positions;     ///< m
  VertexField velocities;    ///< m/s
  StepHistory history = {};  ///< nothing else is needed to go on exactly

  std::size_t bytes() const { return positions.bytes() + velocities.bytes() + history.bytes(); }
};

}  // namespace ringlet
