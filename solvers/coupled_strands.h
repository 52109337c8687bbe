#pragma once

#include <vector>

#include "solvers/newton_iterations.h"
#include "solvers/newton_step.h"

namespace ringlet {

/// All strands of a model as one problem of Newton's method: couplings and contacts hold them
/// together, or the linear solver needs the matrix of all of them.
class CoupledStrands {
 public:
  /// Allocates for a model.
  void bind(const Model& model);

  /// Moves x, the first guess, towards the minimum.
  NewtonOutcome minimise(const NewtonParameters& parameters, const NewtonStep& step,
                         VertexField& x);
  /// Of the potential at x, where minimise() moved it.
  const PotentialTerms& terms() const { return here_.assembled.terms; }
  std::size_t bytes() const;

 private:
  class Problem;
  /// What is known of an iterate x.
  struct Iterate {
    VertexField gradient, direction;
    VertexField trial;  ///< x - d at first
    IncrementalPotential::Assembled assembled;
  };

  Iterate here_, next_;                               ///< x, and the iteration that is tried
  std::vector<NewtonProblem::Direction> directions_;  ///< of each group
};

}  // namespace ringlet
