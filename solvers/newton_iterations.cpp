#include "solvers/newton_iterations.h"

#include <cmath>

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

class NewtonIterations {
 public:
  NewtonIterations(const NewtonParameters& parameters, double dt, NewtonProblem& problem)
      : parameters_(parameters), dt_(dt), problem_(problem) {}

  NewtonOutcome run() {
    while (outcome_.iterations < parameters_.newton_iterations && iterate()) {
    }
    return outcome_;
  }

 private:
  /// False: that was the last one.
  bool iterate() {
    ++outcome_.iterations;
    if (!is_known_) here_ = problem_.begin_iteration();
    is_known_ = false;
    if (!std::isfinite(here_.total) || !std::isfinite(here_.squared_gradient)) {
      return fail(NewtonOutcome::Failure::not_finite);
    }
    outcome_.update = 0;
    outcome_.converged = here_.squared_gradient == 0;
    if (outcome_.converged) return false;
    bool regularised = false;
    if (!find_direction(regularised)) return fail(NewtonOutcome::Failure::no_direction);
    // Of the whole update: a short step of the line search is no sign of being near the minimum.
    outcome_.update = std::sqrt(direction_.squared_update);
    outcome_.converged = !regularised && outcome_.update <= parameters_.newton_tolerance * dt_;
    return move() && !outcome_.converged;
  }

  bool fail(NewtonOutcome::Failure failure) {
    outcome_.converged = false;
    outcome_.failure = failure;
    return false;
  }

  bool find_direction(bool& regularised) {
    if (is_descent()) return true;
    regularised = true;
    double weight = 1 / (dt_ * dt_);
    for (int attempt = 0; attempt < regularisation_attempts; ++attempt) {
      problem_.assemble(weight);
      weight *= regularisation_growth;
      if (is_descent()) return true;
    }
    return false;
  }

  bool is_descent() {
    const auto direction = problem_.find_direction();
    if (!direction) return false;
    direction_ = *direction;
    return direction_.slope > 0 && std::isfinite(direction_.slope);
  }

  /// Moves x as far along the direction as the potential falls, or, without a line search, as
  /// anything lets it move. False: it does not fall; x is unchanged.
  bool move() {
    double alpha = problem_.longest_step();
    if (alpha < 1) problem_.shorten_trial(alpha);
    if (!parameters_.line_search) {
      problem_.take_trial();
      return true;
    }
    for (int halvings = 0; halvings <= halving_limit; ++halvings, alpha /= 2) {
      if (halvings > 0) problem_.shorten_trial(0.5);
      if (falls_enough(look_at_trial(halvings == 0), alpha)) {
        problem_.take_trial();
        return true;
      }
      is_known_ = false;
      ++outcome_.halvings;
    }
    return false;
  }

  // The whole step is nearly always good. Where another iteration follows it is tried with all
  // derivatives at once: its value costs nothing then.
  NewtonProblem::Values look_at_trial(bool is_whole) {
    const bool goes_on = !outcome_.converged && outcome_.iterations < parameters_.newton_iterations;
    if (is_whole && goes_on) {
      if (const auto begun = problem_.begin_iteration_at_trial()) {
        is_known_ = true;
        return *begun;
      }
    }
    return problem_.value_at_trial();
  }

  /// Armijo's condition, but for rounding.
  bool falls_enough(const NewtonProblem::Values& trial, double alpha) {
    const double allowance = rounding * here_.magnitude;
    const bool falls = std::isfinite(trial.total) &&
                       trial.total <= here_.total - armijo * alpha * direction_.slope + allowance;
    if (falls) here_ = trial;
    return falls;
  }

  const NewtonParameters& parameters_;
  const double dt_;
  NewtonProblem& problem_;
  NewtonOutcome outcome_;
  NewtonProblem::Values here_;
  NewtonProblem::Direction direction_;
  bool is_known_ = false;  ///< what begin_iteration() would find
};

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

NewtonOutcome iterate_newton(const NewtonParameters& parameters, double dt,
                             NewtonProblem& problem) {
  return NewtonIterations(parameters, dt, problem).run();
}

}  // namespace ringlet
