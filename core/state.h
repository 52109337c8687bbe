#pragma once

#include <vector>

#include "core/vertex_field.h"

namespace ringlet {

/// What an integrator of several steps knows of the last one.
struct StepHistory {
  double dt = 0;                    ///< length of the last step, s; 0: there was none
  std::vector<VertexField> fields;  ///< as the integrator says

  std::size_t bytes() const {
    std::size_t sum = 0;
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
