// Implicit Euler (BDF-1), math.md section 6: the positions at the end of a step minimise
//
//     Phi(x) = (x - y)^T M (x - y) / (2 dt^2) + potentials,   y = x_n + dt v_n,
//
// and v = (x - x_n) / dt. First order; its numerical damping grows with dt.

#include "core/integrator.h"
#include "core/registry.h"
#include "solvers/integrators/implicit_parameters.h"
#include "solvers/integrators/implicit_step.h"

namespace ringlet {
namespace {

class Bdf1 final : public Integrator {
 public:
  explicit Bdf1(const ImplicitParameters& parameters) : dt_(parameters.dt), implicit_(parameters) {}

  double time_step() const override { return dt_; }
  int order() const override { return 1; }
  void bind(const Model& model) override { implicit_.bind(model); }
  std::size_t bytes() const override { return implicit_.bytes(); }

  StepReport step(Model& model, State& state, double dt) override {
    const StepRule rule = predict(state, dt);
    StepReport report = implicit_.solve(model, state, dt, rule);
    if (report.failure.empty()) implicit_.finish(model, state, dt, rule, report);
    return report;
  }

 private:
  StepRule predict(const State& state, double dt) {
    const auto x = state.positions.rows(), v = state.velocities.rows();
    const auto y = implicit_.target.rows();
    for_each_row(state.positions.groups(), [&](int i) { y[i] = x[i] + Pack(dt) * v[i]; });
    return {dt, dt, state.positions};
  }

  double dt_;
  ImplicitStep implicit_;
};

}  // namespace

void register_bdf1(Registry& registry);
void register_bdf1(Registry& registry) {
  registry.of<Integrator>().add<ImplicitParameters>(
      "bdf1",
      {"implicit Euler: first order, robust at large steps, damps",
       "M (x - x_n - dt v_n) / dt^2 + grad E(x) = f", "Shi et al. 2023; math.md, section 6"},
      [](const ImplicitParameters& parameters) { return std::make_unique<Bdf1>(parameters); });
}

}  // namespace ringlet
