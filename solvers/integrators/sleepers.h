#pragma once

#include <vector>

#include "core/couplings.h"
#include "core/model.h"
#include "core/parameters.h"
#include "core/state.h"

namespace ringlet {

/// When strands that do not move are left out of the solve.
struct SleepParameters {
  double sleep_speed = 0;
  int sleep_steps = 10;

  static Schema<SleepParameters> schema() {
    return Schema<SleepParameters>()
        .key("sleep_speed", &SleepParameters::sleep_speed, "m/s", at_least(0),
             "strands that stay slower are not solved until something moves them; 0: all are")
        .key("sleep_steps", &SleepParameters::sleep_steps, "", at_least(1),
             "for so many steps, after which they fall asleep and between looks at their forces");
  }
};

/// Strands that have come to rest. A group of strands falls asleep once none of its vertices has
/// been faster than the sleep speed for some steps; its vertices are then held where they are, and
/// it costs next to nothing. It wakes as its pins move, or as the forces on it, contacts included,
/// which are looked at every so many steps, would speed up a vertex by more than the sleep speed in
/// one step. Who sleeps is part of the state: StepHistory::still_steps.
class Sleepers {
 public:
  explicit Sleepers(const SleepParameters& parameters) : parameters_(parameters) {}

  bool are_wanted() const { return parameters_.sleep_speed > 0; }
  void bind(const Model& model);
  /// Wakes whose first guess moves, and holds those that sleep: they are not free in the model. The
  /// collision stage is not told, since it must go on to find the contacts that bear on them.
  void hold(Model& model, const State& state, const VertexField& guess);
  /// Whether a group sleeps in this step; it has no velocity then.
  bool holds(int group) const { return are_wanted() && is_held_[group] != 0; }
  /// After a step: who is still, who wakes for the next one. couplings: contacts and couplings as
  /// they were last evaluated.
  void look(const Model& model, State& state, double dt, const Couplings& couplings);

 private:
  bool sleeps(const StepHistory& history, int group) const {
    return history.still_steps[group] >= parameters_.sleep_steps;
  }
  bool is_pushed(const Model& model, const State& state, int group, double dt,
                 const Couplings& couplings) const;

  SleepParameters parameters_;
  VertexScalars free_when_awake_;
  std::vector<char> is_held_;  ///< groups that sleep in this step
};

}  // namespace ringlet
