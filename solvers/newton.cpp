#include "solvers/newton.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "core/parallel.h"
#include "core/registry.h"
#include "core/stiffest_vertex.h"

namespace ringlet {
namespace {

constexpr double armijo = 1e-4;
constexpr int halving_limit = 30;
/// Differences of the potential below this part of its magnitude are rounding errors.
constexpr double rounding = 1e-13;
/// Where the matrix is not positive definite, M / dt^2 is added to it: once, and then a hundred
/// times as much at every further attempt. The last one outweighs any stiffness of a hair.
constexpr int regularisation_attempts = 7;
constexpr double regularisation_growth = 100;

std::string describe_failure(const Model& model, const VertexField& x, int iteration,
                             const std::string& otherwise) {
  return "Newton iteration " + std::to_string(iteration) + ": " +
         find_non_finite(model, x).value_or(otherwise);
}

/// Whether the solver solves each group as soon as it is assembled, and nothing else needs its
/// gradient or direction.
bool solves_groups(const Model& model) {
  return model.solver->band_factor() != nullptr && !model.may_couple();
}

}  // namespace

Schema<NewtonParameters> NewtonParameters::schema() {
  return Schema<NewtonParameters>()
      .key("newton_iterations", &NewtonParameters::newton_iterations, "", at_least(1),
           "cap of Newton iterations a step; the step report tells when it is hit")
      .key("newton_tolerance", &NewtonParameters::newton_tolerance, "m/s", at_least(0),
           "a step is solved when no vertex would move by more than this times dt in an update")
      .key("line_search", &NewtonParameters::line_search, "", any_number(),
           "halve an update until the potential falls");
}

void Newton::bind(const Model& model) {
  matrix_.emplace(model.groups);
  for (Iterate* iterate : {&here_, &next_}) {
    iterate->gradient = iterate->direction = iterate->trial = VertexField(model.groups);
  }
  direction_sums_.resize(model.groups.count());
}

std::size_t Newton::bytes() const {
  std::size_t sum = (matrix_ ? matrix_->bytes() : 0) + bytes_of(direction_sums_);
  for (const Iterate* iterate : {&here_, &next_}) {
    sum += iterate->gradient.bytes() + iterate->direction.bytes() + iterate->trial.bytes();
  }
  return sum;
}

void Newton::minimise(Model& model, IncrementalPotential& potential, double dt, VertexField& x,
                      StepReport& report) {
  report.newton_converged = false;
  is_assembled_ = false;
  Outcome outcome = Outcome::go_on;
  while (outcome == Outcome::go_on && report.newton_iterations < parameters_.newton_iterations) {
    outcome = iterate(model, potential, dt, x, report);
  }
  if (outcome == Outcome::failed) return;
  if (!parameters_.line_search) {
    const StageTimer timer(report.seconds.evaluate);
    potential.value(x, here_.assembled.terms);
    if (!std::isfinite(here_.assembled.terms.total())) {
      report.failure = describe_failure(model, x, report.newton_iterations,
                                        "the potential is not finite after the update");
    }
  }
  report.contact_energy = here_.assembled.terms.contacts;
  report.energies = here_.assembled.terms.energies;
  const auto& couplings = here_.assembled.terms.couplings;
  report.energies.insert(report.energies.end(), couplings.begin(), couplings.end());
  if (model.collision) {
    const StageTimer timer(report.seconds.detect);
    naming(*model.collision, [&] {
      model.collision->end_step(x);
      report.contacts = model.collision->report();
    });
  }
}

void Newton::begin_iteration(Model& model, IncrementalPotential& potential, const VertexField& x,
                             StepReport& report) {
  if (model.collision) {
    const StageTimer timer(report.seconds.detect);
    naming(*model.collision, [&] { model.collision->detect(x); });
  }
  if (model.may_couple()) {
    const StageTimer timer(report.seconds.couple);
    potential.couple(x, *matrix_);
  }
  const StageTimer timer(report.seconds.evaluate);
  assemble(model, potential, x, here_);
}

void Newton::assemble(const Model& model, IncrementalPotential& potential, const VertexField& x,
                      Iterate& iterate, double added) {
  if (solves_groups(model)) {
    const auto see = [&](const auto& solved) { take_up(solved, x, iterate); };
    potential.solve_groups(x, *matrix_, *model.solver, std::ref(see), iterate.assembled, added);
  } else {
    potential.assemble(x, iterate.gradient, *matrix_, *model.solver, iterate.direction,
                       iterate.assembled, added);
  }
}

Newton::Outcome Newton::iterate(Model& model, IncrementalPotential& potential, double dt,
                                VertexField& x, StepReport& report) {
  ++report.newton_iterations;
  if (!is_assembled_) begin_iteration(model, potential, x, report);
  is_assembled_ = false;
  if (!std::isfinite(here_.assembled.terms.total()) ||
      !std::isfinite(here_.assembled.squared_gradient)) {
    report.failure =
        describe_failure(model, x, report.newton_iterations, "a force or contact is not finite");
    return Outcome::failed;
  }
  report.newton_update = 0;
  report.newton_converged = here_.assembled.squared_gradient == 0;
  if (report.newton_converged) return Outcome::done;
  if (!find_direction(model, potential, x, dt, report)) {
    const std::string stiffest =
        describe_stiffest_vertex(model, x, dt).value_or("no energy resists");
    report.failure = describe_failure(
        model, x, report.newton_iterations,
        "the linear solver found no direction in which the potential falls, even with mass "
        "added: " +
            stiffest + "; longer edges, a smaller radius or modulus, or a smaller dt may help");
    return Outcome::failed;
  }
  // Of the whole update: a short step of the line search is no sign of being near the minimum.
  report.newton_update = std::sqrt(squared_update_);
  report.newton_converged =
      !regularised_ && report.newton_update <= parameters_.newton_tolerance * dt;
  if (!parameters_.line_search) {
    const double alpha = longest_step(model, x, report);
    if (alpha < 1) shorten_trial(x, alpha);
    std::swap(x, here_.trial);
  } else if (!search_line(model, potential, x, report)) {
    return Outcome::done;
  }
  return report.newton_converged ? Outcome::done : Outcome::go_on;
}

bool Newton::find_direction(Model& model, IncrementalPotential& potential, const VertexField& x,
                            double dt, StepReport& report) {
  regularised_ = false;
  if (solve(model, x, report)) return true;
  regularised_ = true;
  double weight = 1 / (dt * dt);
  for (int attempt = 0; attempt < regularisation_attempts; ++attempt) {
    {
      const StageTimer timer(report.seconds.evaluate);
      assemble(model, potential, x, here_, weight);
    }
    weight *= regularisation_growth;
    if (solve(model, x, report)) return true;
  }
  return false;
}

/// d = A^-1 grad Phi; false if that is no direction of descent.
bool Newton::solve(const Model& model, const VertexField& x, StepReport& report) {
  const StageTimer timer(report.seconds.solve);
  LinearSolver& solver = *model.solver;
  const bool is_solved = solves_groups(model);
  SolveReport solved;
  const bool can_be_used = naming(solver, [&] {
    if (!solver.prepare(*matrix_)) return false;
    if (!is_solved) solved = solver.solve(here_.gradient, here_.direction);
    return true;
  });
  if (!can_be_used) return false;
  report.linear_iterations += solved.iterations;
  report.linear_converged &= solved.converged;
  report.linear_residual = std::max(report.linear_residual, solved.residual);
  if (!is_solved) {
    parallel_for_each(model.groups.count(), [&](int g) {
      take_up({g, here_.gradient.group(g), here_.direction.group(g)}, x, here_);
    });
  }
  slope_ = squared_update_ = 0;
  for (const DirectionSums& sums : direction_sums_) {
    slope_ += sums.slope;
    squared_update_ = std::max(squared_update_, sums.largest);
  }
  return slope_ > 0 && std::isfinite(slope_);
}

void Newton::take_up(const IncrementalPotential::SolvedGroup& solved, const VertexField& x,
                     Iterate& iterate) {
  const auto& [group, gradient, d] = solved;
  const auto from = x.group(group);
  const auto trial = iterate.trial.group(group);
  Pack slope = 0, largest = 0;
  for (std::size_t i = 0; i < d.size(); ++i) {
    slope += dot(d[i], gradient[i]);
    largest = max(largest, squared_norm(d[i]));
    trial[i] = from[i] - d[i];
  }
  direction_sums_[group] = {sum_lanes(slope), std::experimental::hmax(largest)};
}

double Newton::longest_step(Model& model, const VertexField& x, StepReport& report) {
  if (!model.collision) return 1;
  const StageTimer timer(report.seconds.detect);
  return naming(*model.collision, [&] { return model.collision->step_limit(x, here_.direction); });
}

/// Moves x as far along the direction as the potential falls. False: it does not fall; x is
/// unchanged.
bool Newton::search_line(Model& model, IncrementalPotential& potential, VertexField& x,
                         StepReport& report) {
  double alpha = longest_step(model, x, report);
  if (alpha < 1) shorten_trial(x, alpha);
  for (int halvings = 0; halvings <= halving_limit; ++halvings, alpha /= 2) {
    if (halvings > 0) shorten_trial(x, 0.5);
    // The whole step is nearly always good. Where another iteration follows at the same contacts
    // it is tried with all derivatives at once: its value costs nothing then.
    const bool goes_on = !report.newton_converged && !model.may_couple() &&
                         report.newton_iterations < parameters_.newton_iterations;
    if (halvings == 0 && goes_on) {
      if (try_next_iteration(model, potential, x, report)) return true;
    } else {
      const StageTimer timer(report.seconds.line_search);
      potential.value(here_.trial, next_.assembled.terms);
      if (falls_enough(next_.assembled.terms, alpha)) {
        std::swap(x, here_.trial);
        std::swap(here_.assembled.terms, next_.assembled.terms);
        return true;
      }
    }
    ++report.line_search_halvings;
  }
  return false;
}

void Newton::shorten_trial(const VertexField& x, double factor) {
  parallel_for_each(x.groups().count(), [&](int g) {
    const auto from = x.group(g);
    const auto trial = here_.trial.group(g);
    for (std::size_t i = 0; i < trial.size(); ++i) {
      trial[i] = from[i] + Pack(factor) * (trial[i] - from[i]);
    }
  });
}

bool Newton::try_next_iteration(Model& model, IncrementalPotential& potential, VertexField& x,
                                StepReport& report) {
  const StageTimer timer(report.seconds.evaluate);
  assemble(model, potential, here_.trial, next_);
  if (!falls_enough(next_.assembled.terms, 1)) return false;
  std::swap(x, here_.trial);
  std::swap(here_, next_);
  is_assembled_ = true;
  return true;
}

/// Armijo's condition, but for rounding.
bool Newton::falls_enough(const PotentialTerms& terms, double alpha) const {
  const double allowance = rounding * here_.assembled.terms.magnitude();
  const double start = here_.assembled.terms.total(), total = terms.total();
  return std::isfinite(total) && total <= start - armijo * alpha * slope_ + allowance;
}

}  // namespace ringlet
