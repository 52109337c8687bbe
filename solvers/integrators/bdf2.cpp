// The backward differentiation formula of second order, BDF-2, with steps that may differ: with
// w = dt / dt_{n-1} (1 where they are equal), Hairer, Norsett, Wanner: Solving Ordinary
// Differential Equations I, section III.5,
//
//     x = o + b dt v,   o = c_0 x_n + c_1 x_{n-1},   b = (1 + w) / (1 + 2 w),
//     c_0 = (1 + w)^2 / (1 + 2 w),   c_1 = -w^2 / (1 + 2 w),
//
// and the same for v with M^-1 f(x, v). So the positions minimise
//
//     (x - y)^T M (x - y) / (2 (b dt)^2) + potentials,   y = o + b dt (c_0 v_n + c_1 v_{n-1}).
//
// Second order and L-stable; damps far less than implicit Euler. Zero-stable where no step is more
// than 2.4 times as long as the one before. The first step is one of implicit Euler.

#include <utility>

#include "core/integrator.h"
#include "core/registry.h"
#include "solvers/integrators/implicit_parameters.h"
#include "solvers/integrators/implicit_step.h"

namespace ringlet {
namespace {

class Bdf2 final : public Integrator {
 public:
  explicit Bdf2(const ImplicitParameters& parameters) : dt_(parameters.dt), implicit_(parameters) {}

  double time_step() const override { return dt_; }
  int order() const override { return 2; }
  void bind(const Model& model) override {
    implicit_.bind(model);
    origin_ = VertexField(model.groups);
  }
  std::size_t bytes() const override { return implicit_.bytes() + origin_.bytes(); }

  StepReport step(Model& model, State& state, double dt) override {
    const StepRule rule = predict(state, dt);
    StepReport report = implicit_.solve(model, state, dt, rule);
    if (report.failure.empty()) {
      remember(state);
      implicit_.finish(model, state, dt, rule, report);
    }
    return report;
  }

 private:
  StepRule predict(const State& state, double dt) {
    const bool is_first = state.history.dt == 0;
    const double w = is_first ? 0 : dt / state.history.dt;
    const double b = (1 + w) / (1 + 2 * w);
    const Pack c0 = (1 + w) * (1 + w) / (1 + 2 * w), c1 = -w * w / (1 + 2 * w);
    const auto x = state.positions.rows(), v = state.velocities.rows();
    const auto x_before = is_first ? x : state.history.fields[0].rows();
    const auto v_before = is_first ? v : state.history.fields[1].rows();
    const auto y = implicit_.target.rows(), o = origin_.rows();
    for_each_row(state.positions.groups(), [&](int i) {
      o[i] = c0 * x[i] + c1 * x_before[i];
      y[i] = o[i] + Pack(b * dt) * (c0 * v[i] + c1 * v_before[i]);
    });
    return {b * dt, b * dt, origin_};
  }

  /// The state becomes the history; its own fields are then free to be written.
  static void remember(State& state) {
    state.history.fields.resize(2, state.positions);
    std::swap(state.history.fields[0], state.positions);
    std::swap(state.history.fields[1], state.velocities);
  }

  double dt_;
  ImplicitStep implicit_;
  VertexField origin_;  ///< of the velocities, m
};

}  // namespace

void register_bdf2(Registry& registry);
void register_bdf2(Registry& registry) {
  registry.of<Integrator>().add<ImplicitParameters>(
      "bdf2",
      {"backward differentiation of second order: accurate, stable at large steps, damps little",
       "M (x - o - b dt w) / (b dt)^2 + grad E(x) = f, b = 2/3 at equal steps",
       "Hairer, Norsett, Wanner, section III.5"},
      [](const ImplicitParameters& parameters) { return std::make_unique<Bdf2>(parameters); });
}

}  // namespace ringlet
