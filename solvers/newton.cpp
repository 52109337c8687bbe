#include "solvers/newton.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"

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

/// The largest |v_i| over all vertices.
double largest_norm(const VertexField& v) {
  Pack largest = 0;
  for (const Vector3<Pack>& row : v.rows()) largest = max(largest, squared_norm(row));
  double result = 0;
  for (int lane = 0; lane < lane_count; ++lane) result = std::max<double>(result, largest[lane]);
  return std::sqrt(result);
}

std::string describe_failure(const Model& model, const VertexField& x, int iteration,
                             const std::string& otherwise) {
  return "Newton iteration " + std::to_string(iteration) + ": " +
         find_non_finite(model, x).value_or(otherwise);
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
  gradient_ = direction_ = trial_ = VertexField(model.groups);
  sum_ = GroupSum(model.groups);
}

void Newton::minimise(Model& model, const IncrementalPotential& potential, double dt,
                      VertexField& x, StepReport& report) {
  report.newton_converged = false;
  Outcome outcome = Outcome::go_on;
  while (outcome == Outcome::go_on && report.newton_iterations < parameters_.newton_iterations) {
    outcome = iterate(model, potential, dt, x, report);
  }
  if (outcome == Outcome::failed) return;
  if (!parameters_.line_search) {
    const StageTimer timer(report.seconds.evaluate);
    terms_ = potential.value(x);
    if (!std::isfinite(terms_.total())) {
      report.failure = describe_failure(model, x, report.newton_iterations,
                                        "the potential is not finite after the update");
    }
  }
  report.energies = terms_.energies;
  if (model.collision) report.contacts = model.collision->report();
}

Newton::Outcome Newton::iterate(Model& model, const IncrementalPotential& potential, double dt,
                                VertexField& x, StepReport& report) {
  ++report.newton_iterations;
  if (model.collision) {
    const StageTimer timer(report.seconds.detect);
    model.collision->detect(x);
  }
  {
    const StageTimer timer(report.seconds.evaluate);
    terms_ = potential.assemble(x, gradient_, *matrix_, *model.solver);
  }
  const double squared_gradient = sum_.dot(gradient_, gradient_);
  if (!std::isfinite(terms_.total()) || !std::isfinite(squared_gradient)) {
    report.failure =
        describe_failure(model, x, report.newton_iterations, "a force or contact is not finite");
    return Outcome::failed;
  }
  report.newton_update = 0;
  report.newton_converged = squared_gradient == 0;
  if (report.newton_converged) return Outcome::done;
  if (!find_direction(model, dt, report)) {
    report.failure = describe_failure(
        model, x, report.newton_iterations,
        "the linear solver found no direction in which the potential falls, even with mass added");
    return Outcome::failed;
  }
  // Of the whole update: a short step of the line search is no sign of being near the minimum.
  report.newton_update = largest_norm(direction_);
  report.newton_converged =
      !regularised_ && report.newton_update <= parameters_.newton_tolerance * dt;
  if (!parameters_.line_search) {
    add_scaled(x, -1, direction_);
  } else if (search_line(potential, x, report) == 0) {
    return Outcome::done;
  }
  return report.newton_converged ? Outcome::done : Outcome::go_on;
}

bool Newton::find_direction(Model& model, double dt, StepReport& report) {
  const StageTimer timer(report.seconds.solve);
  regularised_ = false;
  if (solve(*model.solver, report)) return true;
  regularised_ = true;
  double weight = 1 / (dt * dt), added = 0;
  for (int attempt = 0; attempt < regularisation_attempts; ++attempt) {
    add_mass_to_diagonal(model, weight - added);
    added = weight;
    weight *= regularisation_growth;
    if (solve(*model.solver, report)) return true;
  }
  return false;
}

/// d = A^-1 grad Phi; false if that is no direction of descent.
bool Newton::solve(LinearSolver& solver, StepReport& report) {
  if (!solver.prepare(*matrix_)) return false;
  const SolveReport solved = solver.solve(gradient_, direction_);
  report.linear_iterations += solved.iterations;
  report.linear_converged &= solved.converged;
  report.linear_residual = std::max(report.linear_residual, solved.residual);
  slope_ = sum_.dot(gradient_, direction_);
  return slope_ > 0 && std::isfinite(slope_);
}

void Newton::add_mass_to_diagonal(Model& model, double weight) {
  parallel_for_each(model.groups.count(), [&](int g) {
    const GroupBands bands = matrix_->bands.group(g);
    const int first_row = model.groups[g].first_row;
    for (int i = 0; i < bands.rows(); ++i) {
      const Pack added = weight * model.mass[first_row + i] * model.free[first_row + i];
      for (int c = 0; c < 3; ++c) bands.block(i, 0)(c, c) += added;
    }
    model.solver->prepare_group(*matrix_, g);
  });
}

/// Moves x and returns how far, as a part of the direction. 0: the potential does not fall; x and
/// terms_ are unchanged.
double Newton::search_line(const IncrementalPotential& potential, VertexField& x,
                           StepReport& report) {
  const StageTimer timer(report.seconds.line_search);
  const double start = terms_.total();
  const double allowance = rounding * terms_.magnitude();
  double alpha = 1;
  for (int halvings = 0; halvings <= halving_limit; ++halvings, alpha /= 2) {
    trial_ = x;
    add_scaled(trial_, -alpha, direction_);
    PotentialTerms terms = potential.value(trial_);
    const double total = terms.total();
    if (std::isfinite(total) && total <= start - armijo * alpha * slope_ + allowance) {
      std::swap(x, trial_);
      terms_ = std::move(terms);
      return alpha;
    }
    ++report.line_search_halvings;
  }
  return 0;
}

}  // namespace ringlet
