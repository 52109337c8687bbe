#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/integrator.h"
#include "core/model.h"
#include "core/scene.h"
#include "core/state.h"

namespace ringlet {

/// A scene brought to life: its model, state and integrator.
class Simulation {
 public:
  /// Throws Error if strands cannot be made or a part refuses its input.
  explicit Simulation(const Scene& scene);

  const Model& model() const { return *model_; }
  const State& state() const { return state_; }
  const Integrator& integrator() const { return *integrator_; }
  int steps_done() const { return steps_done_; }
  /// Goes on from a state of another simulation of the same strands.
  void set_state(const State& state);
  /// All that the next steps depend on besides the scene; see core/checkpoint.h.
  std::string checkpoint() const;
  /// Goes on from a checkpoint of another simulation of the same scene. Throws Error, and changes
  /// nothing, if it is none.
  void go_on_from(std::string_view checkpoint);
  /// One time step: the six stages of the README. If the report names a failure, the state is
  /// unchanged.
  StepReport step();

 private:
  std::unique_ptr<Model> model_;
  std::unique_ptr<Integrator> integrator_;
  State state_;
  int steps_done_ = 0;
};

/// Where the pins of a model are at a time; x is otherwise unchanged.
void place_pins(const Model& model, double time, VertexField& x);

}  // namespace ringlet
