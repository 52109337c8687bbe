#include "solvers/separate_strands.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/parallel.h"
#include "solvers/trial.h"

namespace ringlet {

class SeparateStrands::Problem final : public NewtonProblem {
 public:
  using Rows = std::span<Vector3<Pack>>;

  Problem(const NewtonStep& step, int group, Rows x, Trials& trials, double& line_search_seconds)
      : step_(step),
        group_(group),
        given_(x),
        x_(x),
        trial_(rows_of(trials.here)),
        next_trial_(rows_of(trials.next)),
        line_search_seconds_(line_search_seconds) {}

  Values begin_iteration() override {
    assemble(0);
    return values(here_.squared_gradient);
  }

  void assemble(double added) override {
    here_ = assemble_at(x_, trial_, added);
    knows_x_ = true;
  }

  std::optional<Direction> find_direction() override {
    return here_.usable ? std::optional(here_.direction) : std::nullopt;
  }

  double longest_step() override { return 1; }
  void shorten_trial(double factor) override { shorten(trial_, x_, factor); }

  Values value_at_trial() override {
    const StageTimer timer(line_search_seconds_);
    trial_is_assembled_ = knows_x_ = false;
    step_.potential.value_of_group(group_, trial_);
    return values(0);
  }

  std::optional<Values> begin_iteration_at_trial() override {
    trial_is_assembled_ = true;
    knows_x_ = false;
    next_ = assemble_at(trial_, next_trial_, 0);
    return values(next_.squared_gradient);
  }

  void take_trial() override {
    std::swap(x_, trial_);
    knows_x_ = true;
    if (!trial_is_assembled_) return;
    std::swap(trial_, next_trial_);
    here_ = next_;
  }

  /// Leaves x, and the potential's terms there, where they belong.
  void finish(bool has_values) {
    if (!has_values || !knows_x_) step_.potential.value_of_group(group_, x_);
    if (x_.data() != given_.data()) std::copy(x_.begin(), x_.end(), given_.begin());
  }

 private:
  struct Iterate {
    double squared_gradient = 0;
    bool usable = false;
    Direction direction;
  };

  Rows rows_of(std::vector<Vector3<Pack>>& vector) const {
    if (vector.size() < given_.size()) vector.resize(given_.size());
    return Rows(vector).first(given_.size());
  }

  Iterate assemble_at(Rows x, Rows trial, double added) {
    SystemMatrix& matrix = step_.matrix;
    const Rows gradient = matrix.temporary_gradient(group_);
    const Rows d = matrix.temporary_direction(group_);
    const auto [squared_gradient, usable] = step_.potential.assemble_group(
        group_, {x, gradient, d, added}, matrix, *step_.model.solver);
    Iterate iterate{squared_gradient, usable, {}};
    if (usable) iterate.direction = follow_direction(gradient, d, x, trial);
    return iterate;
  }

  /// What the potential last found out about this group.
  Values values(double squared_gradient) const {
    Values values{.squared_gradient = squared_gradient};
    for (const double term : step_.potential.terms_of(group_)) {
      values.total += term;
      values.magnitude += std::abs(term);
    }
    return values;
  }

  const NewtonStep& step_;
  const int group_;
  const Rows given_;
  Rows x_, trial_, next_trial_;
  Iterate here_, next_;  ///< x, and the iteration that is tried
  double& line_search_seconds_;
  bool trial_is_assembled_ = false;
  bool knows_x_ = false;  ///< the potential's terms are those at x
};

void SeparateStrands::bind(const Model& model) { solved_.resize(model.groups.count()); }

std::size_t SeparateStrands::bytes() const {
  std::size_t sum = bytes_of(solved_);
  for (const Trials& trials : trials_) sum += bytes_of(trials.here) + bytes_of(trials.next);
  return sum;
}

SeparateStrands::Solved SeparateStrands::minimise_group(const NewtonParameters& parameters,
                                                        const NewtonStep& step, int group,
                                                        VertexField& x) {
  Solved solved;
  {
    const StageTimer timer(solved.seconds);
    Problem problem(step, group, x.group(group), trials_.local(), solved.line_search_seconds);
    solved.outcome = iterate_newton(parameters, step.dt, problem);
    problem.finish(parameters.line_search);
  }
  return solved;
}

NewtonOutcome SeparateStrands::minimise(const NewtonParameters& parameters, const NewtonStep& step,
                                        VertexField& x) {
  double wall_seconds = 0;
  {
    const StageTimer timer(wall_seconds);
    parallel_for_each(step.model.groups.count(),
                      [&](int g) { solved_[g] = minimise_group(parameters, step, g, x); });
    step.potential.sum_terms(terms_);
  }
  double seconds = 0, line_search_seconds = 0;
  for (const Solved& solved : solved_) {
    seconds += solved.seconds;
    line_search_seconds += solved.line_search_seconds;
  }
  // Several threads measure at once: their shares are those of the whole.
  const double in_line_search = seconds > 0 ? wall_seconds * line_search_seconds / seconds : 0;
  step.report.seconds.line_search += in_line_search;
  step.report.seconds.evaluate += wall_seconds - in_line_search;
  return outcome_of_all();
}

NewtonOutcome SeparateStrands::outcome_of_all() const {
  NewtonOutcome all{.converged = true};
  for (const Solved& solved : solved_) {
    const NewtonOutcome& one = solved.outcome;
    if (one.failure != NewtonOutcome::Failure::none) return one;
    all.iterations = std::max(all.iterations, one.iterations);
    all.halvings = std::max(all.halvings, one.halvings);
    all.update = std::max(all.update, one.update);
    all.converged &= one.converged;
  }
  return all;
}

}  // namespace ringlet
