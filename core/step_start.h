#pragma once

#include <memory>
#include <span>

#include "core/state.h"

namespace ringlet {

class Energy;

/// How the velocities at the end of a step follow from the positions there: v = (x - origin) /
/// interval. Of implicit Euler these are the positions at the beginning of the step and its length.
struct EndVelocity {
  const VertexField& origin;  ///< m
  double interval;            ///< s
};

/// What a term of the potential may look at when a step begins.
struct StepStart {
  const State& state;                                 ///< at the beginning of the step
  double dt;                                          ///< s
  std::span<const std::unique_ptr<Energy>> energies;  ///< the elastic potential
  EndVelocity velocity;

  double end() const { return state.time + dt; }  ///< s
};

}  // namespace ringlet
