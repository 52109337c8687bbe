#include "solvers/integrators/implicit_step.h"

#include <utility>

#include "core/kinetic_energy.h"
#include "core/registry.h"
#include "core/simulation.h"
#include "solvers/integrators/first_guess.h"

namespace ringlet {

void ImplicitStep::bind(const Model& model) {
  target = positions_ = VertexField(model.groups);
  potential_.emplace(model, target, 1);
  newton_.bind(model);
  sleepers_.bind(model);
}

std::size_t ImplicitStep::bytes() const {
  return target.bytes() + positions_.bytes() + newton_.bytes() +
         (potential_ ? potential_->bytes() : 0);
}

StepReport ImplicitStep::solve(Model& model, const State& state, double dt, const StepRule& rule) {
  StepReport report;
  const double time_end = state.time + dt;
  carry_strands_with_pins(model, state.positions, state.time, time_end, positions_);
  sleepers_.hold(model, state, positions_);
  begin_step(model, state, dt, {rule.origin, rule.interval});
  if (model.collision) {
    const StageTimer timer(report.seconds.detect);
    const bool reachable = naming(*model.collision, [&] {
      model.collision->begin_step(state.positions, time_end, dt);
      return find_reachable_guess(model, state, time_end);
    });
    if (!reachable) {
      report.failure =
          "as pins and colliders move in this step, strands pass through each other or vertices "
          "through a collider, which the contact barrier forbids; a smaller dt may help";
      return report;
    }
  }
  potential_->set_effective_step(rule.h);
  newton_.minimise(model, *potential_, dt, positions_, report);
  return report;
}

/// The first guess, or, if carrying strands takes them through each other, that of pins alone.
bool ImplicitStep::find_reachable_guess(const Model& model, const State& state, double time_end) {
  if (model.collision->can_reach(state.positions, positions_)) return true;
  positions_ = state.positions;
  place_pins(model, time_end, positions_);
  return model.collision->can_reach(state.positions, positions_);
}

void ImplicitStep::finish(const Model& model, State& state, double dt, const StepRule& rule,
                          StepReport& report) {
  report.kinetic_energy = parallel_sum(model.groups.count(), [&](int g) {
    const auto v = state.velocities.group(g);
    const auto x = std::as_const(positions_).group(g), o = rule.origin.group(g);
    const Pack inverse = sleepers_.holds(g) ? 0 : 1 / rule.interval;
    for (std::size_t i = 0; i < v.size(); ++i) v[i] = inverse * (x[i] - o[i]);
    return kinetic_energy(model, state.velocities, g);
  });
  std::swap(state.positions, positions_);
  state.time += dt;
  state.history.dt = dt;
  sleepers_.look(model, state, dt, newton_.couplings());
}

}  // namespace ringlet
