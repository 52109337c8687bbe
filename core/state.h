#pragma once

#include "core/vertex_field.h"

namespace ringlet {

/// The state of a simulation: time, positions and velocities of all vertices.
struct State {
  double time = 0;         ///< s
  VertexField positions;   ///< m
  VertexField velocities;  ///< m/s
};

}  // namespace ringlet
