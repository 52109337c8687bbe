#include "solvers/coupled_strands.h"

#include <algorithm>
#include <utility>

#include "core/parallel.h"
#include "core/registry.h"
#include "solvers/trial.h"

namespace ringlet {

class CoupledStrands::Problem final : public NewtonProblem {
 public:
  Problem(CoupledStrands& storage, const NewtonStep& step, VertexField& x)
      : here_(storage.here_),
        next_(storage.next_),
        directions_(storage.directions_),
        model_(step.model),
        potential_(step.potential),
        matrix_(step.matrix),
        report_(step.report),
        x_(x) {}

  Values begin_iteration() override {
    if (model_.collision) {
      const StageTimer timer(report_.seconds.detect);
      naming(*model_.collision, [&] { model_.collision->detect(x_); });
    }
    if (model_.may_couple()) {
      const StageTimer timer(report_.seconds.couple);
      potential_.couple(x_, matrix_);
    }
    assemble(0);
    return values_of(here_);
  }

  void assemble(double added) override { assemble(x_, here_, added); }

  std::optional<Direction> find_direction() override {
    const StageTimer timer(report_.seconds.solve);
    if (!here_.assembled.usable || !solve()) return std::nullopt;
    parallel_for_each(model_.groups.count(), [&](int g) {
      directions_[g] = follow_direction(std::as_const(here_.gradient).group(g),
                                        std::as_const(here_.direction).group(g),
                                        std::as_const(x_).group(g), here_.trial.group(g));
    });
    Direction all;
    for (const Direction& of_group : directions_) {
      all.slope += of_group.slope;
      all.squared_update = std::max(all.squared_update, of_group.squared_update);
    }
    return all;
  }

  double longest_step() override {
    if (!model_.collision) return 1;
    const StageTimer timer(report_.seconds.detect);
    return naming(*model_.collision,
                  [&] { return model_.collision->step_limit(x_, here_.direction); });
  }

  void shorten_trial(double factor) override {
    parallel_for_each(model_.groups.count(), [&](int g) {
      shorten(here_.trial.group(g), std::as_const(x_).group(g), factor);
    });
  }

  Values value_at_trial() override {
    const StageTimer timer(report_.seconds.line_search);
    trial_is_assembled_ = false;
    potential_.value(here_.trial, next_.assembled.terms);
    return values_of(next_);
  }

  std::optional<Values> begin_iteration_at_trial() override {
    // Other contacts than those at x may be close there.
    if (model_.may_couple()) return std::nullopt;
    trial_is_assembled_ = true;
    assemble(here_.trial, next_, 0);
    return values_of(next_);
  }

  void take_trial() override {
    std::swap(x_, here_.trial);
    if (trial_is_assembled_) {
      std::swap(here_, next_);
    } else {
      std::swap(here_.assembled.terms, next_.assembled.terms);
    }
  }

 private:
  static Values values_of(const Iterate& iterate) {
    const auto& [terms, squared_gradient, usable] = iterate.assembled;
    return {terms.total(), terms.magnitude(), squared_gradient};
  }

  void assemble(const VertexField& x, Iterate& iterate, double added) {
    const StageTimer timer(report_.seconds.evaluate);
    potential_.assemble(x, iterate.gradient, matrix_, *model_.solver, iterate.direction,
                        iterate.assembled, added);
  }

  /// d = A^-1 grad Phi.
  bool solve() {
    LinearSolver& solver = *model_.solver;
    return naming(solver, [&] {
      if (!solver.prepare(matrix_)) return false;
      const SolveReport solved = solver.solve(here_.gradient, here_.direction);
      report_.linear_iterations += solved.iterations;
      report_.linear_converged &= solved.converged;
      report_.linear_residual = std::max(report_.linear_residual, solved.residual);
      return true;
    });
  }

  Iterate &here_, &next_;
  std::vector<Direction>& directions_;
  Model& model_;
  IncrementalPotential& potential_;
  SystemMatrix& matrix_;
  StepReport& report_;
  VertexField& x_;
  bool trial_is_assembled_ = false;
};

void CoupledStrands::bind(const Model& model) {
  here_.gradient = here_.direction = here_.trial = VertexField(model.groups);
  if (!model.may_couple()) next_.gradient = next_.direction = next_.trial = here_.trial;
  directions_.resize(model.groups.count());
}

std::size_t CoupledStrands::bytes() const {
  std::size_t sum = bytes_of(directions_);
  for (const Iterate* iterate : {&here_, &next_}) {
    sum += iterate->gradient.bytes() + iterate->direction.bytes() + iterate->trial.bytes();
  }
  return sum;
}

NewtonOutcome CoupledStrands::minimise(const NewtonParameters& parameters, const NewtonStep& step,
                                       VertexField& x) {
  Problem problem(*this, step, x);
  const NewtonOutcome outcome = iterate_newton(parameters, step.dt, problem);
  if (!parameters.line_search && outcome.failure == NewtonOutcome::Failure::none) {
    const StageTimer timer(step.report.seconds.evaluate);
    step.potential.value(x, here_.assembled.terms);
  }
  return outcome;
}

}  // namespace ringlet
