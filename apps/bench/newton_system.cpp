#include "apps/bench/newton_system.h"

namespace ringlet {

NewtonSystem::NewtonSystem(const Simulation& simulation, double dt)
    : model_(simulation.model()), x_(simulation.state().positions), target_(x_), dt_(dt) {
  const State& state = simulation.state();
  add_scaled(target_, dt, state.velocities);
  place_pins(model_, state.time + dt, x_);
  if (model_.collision) {
    model_.collision->begin_step(state.positions, state.time + dt, dt);
    model_.collision->detect(x_);
  }
  for (const auto& force : model_.forces)
    force->begin_step({state, dt, model_.energies, {state.positions, dt}});
}

int NewtonSystem::contacts() const {
  const ContactReport report = model_.collision->report();
  return report.strand_contacts + report.collider_contacts;
}

void NewtonSystem::assemble(LinearSolver& solver, SystemMatrix& matrix, VertexField& gradient,
                            VertexField& solution) const {
  IncrementalPotential potential(model_, target_, dt_);
  if (model_.collision) potential.couple(x_, matrix);
  IncrementalPotential::Assembled result;
  potential.assemble(x_, gradient, matrix, solver, solution, result);
}

}  // namespace ringlet
