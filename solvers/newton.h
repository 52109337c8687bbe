#pragma once

#include <optional>

#include "core/incremental_potential.h"
#include "core/parameters.h"
#include "core/step_report.h"
#include "solvers/group_sum.h"

namespace ringlet {

/// Parameters that every implicit integrator has.
struct NewtonParameters {
  int newton_iterations = 20;
  double newton_tolerance = 1e-3;
  bool line_search = true;

  static Schema<NewtonParameters> schema();
};

/// Newton's method on the incremental potential of a step, with the filtered Hessian A:
///
///     A(x) d = grad Phi(x),   x <- x - alpha d
///
/// It stops when no vertex would move by more than newton_tolerance * dt in a whole update (the
/// velocity at the end of the step is then known to about newton_tolerance), or at the iteration
/// cap, which the report tells. alpha is 1, or, with the line search, the largest power of 1/2 with
/// Phi(x - alpha d) <= Phi(x) - c alpha d^T grad Phi (Armijo; Nocedal, Wright: Numerical
/// Optimization, algorithm 3.1); a value that is not finite is never accepted.
class Newton {
 public:
  explicit Newton(const NewtonParameters& parameters) : parameters_(parameters) {}

  /// Allocates for a model. Called once.
  void bind(const Model& model);

  /// Moves x, which holds the first guess with the pins in place, towards the minimum. Writes
  /// everything but the kinetic energy into the report. If the report names a failure, x is of no
  /// use.
  void minimise(Model& model, const IncrementalPotential& potential, double dt, VertexField& x,
                StepReport& report);

 private:
  enum class Outcome { go_on, done, failed };
  Outcome iterate(Model& model, const IncrementalPotential& potential, double dt, VertexField& x,
                  StepReport& report);
  bool find_direction(Model& model, double dt, StepReport& report);
  bool solve(LinearSolver& solver, StepReport& report);
  void add_mass_to_diagonal(Model& model, double weight);
  double search_line(const IncrementalPotential& potential, VertexField& x, StepReport& report);

  NewtonParameters parameters_;
  std::optional<SystemMatrix> matrix_;
  VertexField gradient_, direction_, trial_;
  GroupSum sum_;
  PotentialTerms terms_;  ///< at x
  double slope_ = 0;      ///< d^T grad Phi, J
  bool regularised_ = false;
};

}  // namespace ringlet
