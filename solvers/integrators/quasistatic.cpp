// Equilibrium at every step, without inertia: the positions minimise the potentials alone. Pins,
// colliders and what changes with time still move, and drag and damping still resist with
// v = (x - x_n) / dt, so that strands with one of them creep towards equilibrium. Where the
// potentials do not hold a strand at all, as where nothing pins it, Newton's method adds mass.

#include <limits>

#include "core/integrator.h"
#include "core/registry.h"
#include "solvers/integrators/implicit_parameters.h"
#include "solvers/integrators/implicit_step.h"

namespace ringlet {
namespace {

struct QuasistaticParameters {
  ImplicitParameters implicit{1.0 / 30, {.newton_iterations = 200}, {}};

  static Schema<QuasistaticParameters> schema() {
    return Schema<QuasistaticParameters>().include(&QuasistaticParameters::implicit);
  }
};

class Quasistatic final : public Integrator {
 public:
  explicit Quasistatic(const ImplicitParameters& parameters)
      : dt_(parameters.dt), implicit_(parameters) {}

  double time_step() const override { return dt_; }
  int order() const override { return 1; }
  void bind(const Model& model) override { implicit_.bind(model); }
  std::size_t bytes() const override { return implicit_.bytes(); }

  StepReport step(Model& model, State& state, double dt) override {
    const StepRule rule{std::numeric_limits<double>::infinity(), dt, state.positions};
    const auto x = state.positions.rows();
    const auto y = implicit_.target.rows();
    for_each_row(model.groups, [&](int i) { y[i] = x[i]; });
    StepReport report = implicit_.solve(model, state, dt, rule);
    if (report.failure.empty()) implicit_.finish(model, state, dt, rule, report);
    return report;
  }

 private:
  double dt_;
  ImplicitStep implicit_;
};

}  // namespace

void register_quasistatic(Registry& registry);
void register_quasistatic(Registry& registry) {
  registry.of<Integrator>().add<QuasistaticParameters>(
      "quasistatic", {"equilibrium at every step, without inertia", "grad E(x) = f", ""},
      [](const QuasistaticParameters& parameters) {
        return std::make_unique<Quasistatic>(parameters.implicit);
      });
}

}  // namespace ringlet
