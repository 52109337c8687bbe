// Newmark's method (A Method of Computation for Structural Dynamics, 1959):
//
//     x = x_n + dt v_n + dt^2 ((1/2 - beta) a_n + beta a),   v = v_n + dt ((1 - gamma) a_n + gamma
//     a), M a = f(x, v) - grad E(x),   beta = (gamma + 1/2)^2 / 4.
//
// With gamma = 1/2, the mean acceleration, it is of second order and keeps the energy of linear
// systems; a larger gamma damps fast motion, but is of first order. With that beta it is stable at
// every step for linear systems, and damps the fastest motion most (Hughes: The Finite Element
// Method, section 9.2). So the positions minimise
//
//     (x - y)^T M (x - y) / (2 beta dt^2) + potentials,   y = x_n + dt v_n + dt^2 (1/2 - beta) a_n,
//
// and a = (x - y) / (beta dt^2). Before the first step a is not known: that step is taken with the
// acceleration at its end alone, beta = 1/2 and gamma = 1, whose error of one step is O(dt^2).

#include <cmath>
#include <utility>

#include "core/integrator.h"
#include "core/registry.h"
#include "solvers/integrators/implicit_parameters.h"
#include "solvers/integrators/implicit_step.h"

namespace ringlet {
namespace {

struct NewmarkParameters {
  ImplicitParameters implicit;
  double gamma = 0.5;

  static Schema<NewmarkParameters> schema() {
    return Schema<NewmarkParameters>()
        .include(&NewmarkParameters::implicit)
        .key("gamma", &NewmarkParameters::gamma, "", between(0.5, 1.5),
             "1/2 keeps energy, more damps fast motion");
  }
};

class Newmark final : public Integrator {
 public:
  explicit Newmark(const NewmarkParameters& parameters)
      : dt_(parameters.implicit.dt), gamma_(parameters.gamma), implicit_(parameters.implicit) {}

  double time_step() const override { return dt_; }
  int order() const override { return gamma_ == 0.5 ? 2 : 1; }
  void bind(const Model& model) override {
    implicit_.bind(model);
    origin_ = VertexField(model.groups);
  }
  std::size_t bytes() const override { return implicit_.bytes() + origin_.bytes(); }

  StepReport step(Model& model, State& state, double dt) override {
    const Weights weights = weights_after(state.history);
    const StepRule rule = predict(state, dt, weights);
    StepReport report = implicit_.solve(model, state, dt, rule);
    if (!report.failure.empty()) return report;
    remember_acceleration(model, state.history, rule);
    let_pins_move_evenly(model, state, dt, rule);
    implicit_.finish(model, state, dt, rule, report);
    return report;
  }

 private:
  struct Weights {
    double beta, gamma;
  };
  Weights weights_after(const StepHistory& history) const {
    if (history.dt == 0) return {0.5, 1};
    return {(gamma_ + 0.5) * (gamma_ + 0.5) / 4, gamma_};
  }

  StepRule predict(State& state, double dt, const Weights& weights) {
    const auto [beta, gamma] = weights;
    if (state.history.fields.empty()) state.history.fields.emplace_back(state.positions.groups());
    if (state.history.dt == 0) state.history.fields[0].set_zero();
    const double interval = beta * dt / gamma;
    const auto x = state.positions.rows(), v = state.velocities.rows();
    const auto a = state.history.fields[0].rows();
    const auto y = implicit_.target.rows(), o = origin_.rows();
    for_each_row(state.positions.groups(), [&, beta = beta, gamma = gamma](int i) {
      y[i] = x[i] + Pack(dt) * v[i] + Pack(dt * dt * (0.5 - beta)) * a[i];
      o[i] = y[i] - Pack(interval) * (v[i] + Pack(dt * (1 - gamma)) * a[i]);
    });
    return {dt * std::sqrt(beta), interval, origin_};
  }

  void remember_acceleration(const Model& model, StepHistory& history, const StepRule& rule) {
    const auto x = implicit_.positions().rows();
    const auto y = std::as_const(implicit_.target).rows();
    const auto a = history.fields[0].rows();
    for_each_row(model.groups, [&](int i) {
      a[i] = Pack(1 / (rule.h * rule.h)) * model.free[i] * (x[i] - y[i]);
    });
  }

  /// Where a vertex is led, nothing damps what a and v would swing by at every step: it moves with
  /// a = 0 and v = (x - x_n) / dt.
  void let_pins_move_evenly(const Model& model, const State& state, double dt,
                            const StepRule& rule) {
    for (const Pin& pin : model.pins) {
      const Eigen::Vector3d x = implicit_.positions().get(pin.vertex);
      const Eigen::Vector3d moved = x - state.positions.get(pin.vertex);
      origin_.set(pin.vertex, x - rule.interval / dt * moved);
    }
  }

  double dt_, gamma_;
  ImplicitStep implicit_;
  VertexField origin_;  ///< of the velocities, m
};

}  // namespace

void register_newmark(Registry& registry);
void register_newmark(Registry& registry) {
  registry.of<Integrator>().add<NewmarkParameters>(
      "newmark",
      {"Newmark's method: second order, keeps energy; needs small steps where it moves fast",
       "M (x - x_n - dt v_n - dt^2 (1/2 - beta) a_n) / (beta dt^2) + grad E(x) = f",
       "Newmark 1959"},
      [](const NewmarkParameters& parameters) { return std::make_unique<Newmark>(parameters); });
}

}  // namespace ringlet
