#pragma once

#include <memory>
#include <span>

#include "core/state.h"

namespace ringlet {

class Energy;

/// What a term of the potential may look at when a step begins.
struct StepStart {
  const State& state;                                 ///< at the beginning of the step
  double dt;                                          ///< s
  std::span<const std::unique_ptr<Energy>> energies;  ///< the elastic potential

  double end() const { return state.time + dt; }  ///< s
};

}  // namespace ringlet
