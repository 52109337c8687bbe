#pragma once

#include <optional>
#include <vector>

#include "core/incremental_potential.h"
#include "core/parameters.h"
#include "core/step_report.h"

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
/// cap, which the report tells. alpha is 1, or what the collision stage allows; with the line
/// search that times the largest power of 1/2 with Phi(x - alpha d) <= Phi(x) - c alpha d^T grad
/// Phi (Armijo; Nocedal, Wright: Numerical Optimization, algorithm 3.1); a value that is not finite
/// is never accepted.
class Newton {
 public:
  explicit Newton(const NewtonParameters& parameters) : parameters_(parameters) {}

  /// Allocates for a model. Called once.
  void bind(const Model& model);

  /// Moves x, which holds the first guess with the pins in place, towards the minimum. Writes
  /// everything but the kinetic energy into the report. If the report names a failure, x is of no
  /// use.
  void minimise(Model& model, IncrementalPotential& potential, double dt, VertexField& x,
                StepReport& report);

  /// Contacts and couplings as they were last evaluated.
  const Couplings& couplings() const { return matrix_->couplings; }
  /// The memory that it holds, the matrix included.
  std::size_t bytes() const;

 private:
  enum class Outcome { go_on, done, failed };
  Outcome iterate(Model& model, IncrementalPotential& potential, double dt, VertexField& x,
                  StepReport& report);
  /// What is known of an iterate x.
  struct Iterate {
    VertexField gradient, direction;  ///< not written where solves_groups()
    VertexField trial;                ///< x - d at first
    IncrementalPotential::Assembled assembled;
  };
  struct DirectionSums {
    double slope, largest;
  };

  void begin_iteration(Model& model, IncrementalPotential& potential, const VertexField& x,
                       StepReport& report);
  void assemble(const Model& model, IncrementalPotential& potential, const VertexField& x,
                Iterate& iterate, double added = 0);
  bool find_direction(Model& model, IncrementalPotential& potential, const VertexField& x,
                      double dt, StepReport& report);
  bool solve(const Model& model, const VertexField& x, StepReport& report);
  /// What follows from the direction of a group: its sums and its trial.
  void take_up(const IncrementalPotential::SolvedGroup& solved, const VertexField& x,
               Iterate& iterate);
  /// The alpha with which the line search begins.
  double longest_step(Model& model, const VertexField& x, StepReport& report);
  bool search_line(Model& model, IncrementalPotential& potential, VertexField& x,
                   StepReport& report);
  /// Moves the trial towards x, until their distance is so many times what it was.
  void shorten_trial(const VertexField& x, double factor);
  bool try_next_iteration(Model& model, IncrementalPotential& potential, VertexField& x,
                          StepReport& report);
  bool falls_enough(const PotentialTerms& terms, double alpha) const;

  NewtonParameters parameters_;
  std::optional<SystemMatrix> matrix_;
  Iterate here_, next_;                        ///< x, and the iteration that is tried
  std::vector<DirectionSums> direction_sums_;  ///< of each group
  bool is_assembled_ = false;                  ///< what is known of x is already known
  double slope_ = 0;                           ///< d^T grad Phi, J
  double squared_update_ = 0;                  ///< of the vertex that moves most, m^2
  bool regularised_ = false;
};

}  // namespace ringlet
