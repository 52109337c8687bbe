// Implicit Euler (BDF-1), math.md section 6: the positions at the end of a step minimise
//
//     Phi(x) = (x - y)^T M (x - y) / (2 dt^2) + potentials,   y = x_n + dt v_n,
//
// and v = (x - x_n) / dt. First order; its numerical damping grows with dt.

#include <utility>

#include "core/integrator.h"
#include "core/registry.h"
#include "solvers/first_guess.h"
#include "solvers/kinetic_energy.h"
#include "solvers/newton.h"

namespace ringlet {
namespace {

struct Bdf1Parameters {
  double dt = 1.0 / 30;
  NewtonParameters newton;

  static Schema<Bdf1Parameters> schema() {
    return Schema<Bdf1Parameters>()
        .key("dt", &Bdf1Parameters::dt, "s", positive(), "time step")
        .include(&Bdf1Parameters::newton);
  }
};

class Bdf1 final : public Integrator {
 public:
  explicit Bdf1(const Bdf1Parameters& parameters)
      : dt_(parameters.dt), newton_(parameters.newton) {}

  double time_step() const override { return dt_; }

  void bind(const Model& model) override {
    target_ = positions_ = VertexField(model.groups);
    newton_.bind(model);
  }

  StepReport step(Model& model, State& state) override {
    StepReport report;
    const double time_end = state.time + dt_;
    target_ = state.positions;
    add_scaled(target_, dt_, state.velocities);
    positions_ = state.positions;
    carry_strands_with_pins(model, state.time, time_end, positions_);

    for (const auto& force : model.forces) force->begin_step({state, dt_, model.energies});
    if (model.collision) {
      const StageTimer timer(report.seconds.detect);
      model.collision->begin_step(state.positions, time_end, dt_);
    }
    newton_.minimise(model, IncrementalPotential(model, target_, dt_), dt_, positions_, report);
    if (!report.failure.empty()) return report;

    state.velocities = positions_;
    add_scaled(state.velocities, -1, state.positions);
    for (Vector3<Pack>& v : state.velocities.rows()) v = Pack(1 / dt_) * v;
    std::swap(state.positions, positions_);
    state.time = time_end;
    report.kinetic_energy = kinetic_energy(model, state.velocities);
    return report;
  }

 private:
  double dt_;
  Newton newton_;
  VertexField target_, positions_;
};

}  // namespace

void register_bdf1(Registry& registry) {
  registry.of<Integrator>().add<Bdf1Parameters>(
      "bdf1",
      {"implicit Euler: first order, robust at large steps, damps",
       "M (x - x_n - dt v_n) / dt^2 + grad E(x) = f", "Shi et al. 2023; math.md, section 6"},
      [](const Bdf1Parameters& parameters) { return std::make_unique<Bdf1>(parameters); });
}

}  // namespace ringlet
