#pragma once

#include <optional>

#include "core/parameters.h"

namespace ringlet {

/// Parameters that every implicit integrator has.
struct NewtonParameters {
  int newton_iterations = 20;
  double newton_tolerance = 1e-3;
  bool line_search = true;

  static Schema<NewtonParameters> schema();
};

/// What Newton's method asks of a potential Phi of positions x: of all strands together, or of some
/// that nothing couples with the others. It holds x, and the trial to which x may move.
class NewtonProblem {
 public:
  virtual ~NewtonProblem() = default;

  /// Of Phi at x or at the trial.
  struct Values {
    double total = 0;             ///< Phi, J
    double magnitude = 0;         ///< the scale of the rounding errors in it, J
    double squared_gradient = 0;  ///< |grad Phi|^2, N^2
  };
  /// Of the solution d of A d = grad Phi.
  struct Direction {
    double slope = 0;           ///< d^T grad Phi, J
    double squared_update = 0;  ///< of the vertex that moves most, m^2
  };

  /// Values at x, with derivatives.
  virtual Values begin_iteration() = 0;
  /// The same again, but with A plus `added` M.
  virtual void assemble(double added) = 0;
  /// The direction from x; makes the trial x - d. Nothing: the matrix cannot be used.
  virtual std::optional<Direction> find_direction() = 0;
  /// How far along the direction anything lets x move, at most 1: all of it.
  virtual double longest_step() = 0;
  /// Moves the trial towards x, until their distance is so many times what it was.
  virtual void shorten_trial(double factor) = 0;
  /// Only total and magnitude, at the trial.
  virtual Values value_at_trial() = 0;
  /// What begin_iteration() would give if x were the trial. Nothing: it is no faster at once than
  /// after value_at_trial().
  virtual std::optional<Values> begin_iteration_at_trial() = 0;
  /// Moves x to the trial, and what was last found out there with it.
  virtual void take_trial() = 0;
};

/// How Newton's method ended.
struct NewtonOutcome {
  enum class Failure { none, not_finite, no_direction };

  int iterations = 0;
  bool converged = false;
  double update = 0;  ///< of the vertex that moved most in the last whole update, m
  int halvings = 0;   ///< of updates by the line search
  Failure failure = Failure::none;
};

/// Newton's method, with the filtered Hessian A:
///
///     A(x) d = grad Phi(x),   x <- x - alpha d
///
/// It stops when no vertex would move by more than newton_tolerance * dt in a whole update (the
/// velocity at the end of the step is then known to about newton_tolerance), or at the iteration
/// cap, which the outcome tells. alpha is the longest step, with the line search times the largest
/// power of 1/2 with Phi(x - alpha d) <= Phi(x) - c alpha d^T grad Phi (Armijo; Nocedal, Wright:
/// Numerical Optimization, algorithm 3.1); a value that is not finite is never accepted.
NewtonOutcome iterate_newton(const NewtonParameters& parameters, double dt, NewtonProblem& problem);

}  // namespace ringlet
