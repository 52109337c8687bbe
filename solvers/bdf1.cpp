// Implicit Euler (BDF-1), math.md section 6: the positions at the end of a step minimise
//
//     Phi(x) = (x - y)^T M (x - y) / (2 dt^2) + potentials,   y = x_n + dt v_n,
//
// and v = (x - x_n) / dt. First order; its numerical damping grows with dt.

#include <optional>
#include <utility>

#include "core/integrator.h"
#include "core/registry.h"
#include "core/simulation.h"
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
    potential_.emplace(model, target_, dt_);
    newton_.bind(model);
  }

  StepReport step(Model& model, State& state) override {
    StepReport report;
    const double time_end = state.time + dt_;
    predict(state);
    carry_strands_with_pins(model, state.time, time_end, positions_);

    begin_step(model, state, dt_);
    if (model.collision) {
      const StageTimer timer(report.seconds.detect);
      const bool reachable = naming(*model.collision, [&] {
        model.collision->begin_step(state.positions, time_end, dt_);
        return find_reachable_guess(model, state, time_end);
      });
      if (!reachable) {
        report.failure =
            "as pins and colliders move in this step, strands pass through each other or vertices "
            "through a collider, which the contact barrier forbids; a smaller dt may help";
        return report;
      }
    }
    newton_.minimise(model, *potential_, dt_, positions_, report);
    if (!report.failure.empty()) return report;

    update_velocities(state);
    std::swap(state.positions, positions_);
    state.time = time_end;
    report.kinetic_energy = kinetic_energy(model, state.velocities);
    return report;
  }

 private:
  /// The first guess, or, if carrying strands takes them through each other, that of pins alone.
  bool find_reachable_guess(const Model& model, const State& state, double time_end) {
    if (model.collision->can_reach(state.positions, positions_)) return true;
    positions_ = state.positions;
    place_pins(model, time_end, positions_);
    return model.collision->can_reach(state.positions, positions_);
  }
  /// y = x + dt v, and x as the first guess.
  void predict(const State& state) {
    parallel_for_each(target_.groups().count(), [&](int g) {
      const auto x = state.positions.group(g), v = state.velocities.group(g);
      const auto y = target_.group(g), guess = positions_.group(g);
      for (std::size_t i = 0; i < x.size(); ++i) {
        y[i] = x[i] + Pack(dt_) * v[i];
        guess[i] = x[i];
      }
    });
  }
  /// v = (x - x_n) / dt.
  void update_velocities(State& state) const {
    parallel_for_each(target_.groups().count(), [&](int g) {
      const auto x = positions_.group(g), x_n = std::as_const(state.positions).group(g);
      const auto v = state.velocities.group(g);
      for (std::size_t i = 0; i < x.size(); ++i) v[i] = Pack(1 / dt_) * (x[i] - x_n[i]);
    });
  }

  double dt_;
  Newton newton_;
  VertexField target_, positions_;
  std::optional<IncrementalPotential> potential_;  // of a step to the target
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
