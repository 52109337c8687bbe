#pragma once

#include "core/model.h"
#include "core/named.h"
#include "core/state.h"
#include "core/step_report.h"

namespace ringlet {

/// Advances a state in time.
class Integrator : public Named {
 public:
  virtual ~Integrator() = default;
  /// The time between two states that observers see, s.
  virtual double time_step() const = 0;
  /// The order p of its global error, O(dt^p).
  virtual int order() const = 0;
  /// Called once, before the first step.
  virtual void bind(const Model& model) = 0;
  /// Advances the state from its time to time + dt; dt may differ from step to step. On failure the
  /// report says what and where, and the state is unchanged.
  virtual StepReport step(Model& model, State& state, double dt) = 0;
};

}  // namespace ringlet
