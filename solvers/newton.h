#pragma once

#include <optional>

#include "solvers/coupled_strands.h"
#include "solvers/separate_strands.h"

namespace ringlet {

/// Newton's method on the incremental potential of a step: for groups of strands by themselves
/// where that suits the model, else for all strands together.
class Newton {
 public:
  explicit Newton(const NewtonParameters& parameters) : parameters_(parameters) {}

  /// Allocates for a model, whose solver is bound. Called once.
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
  void take_outcome(const NewtonOutcome& outcome, const PotentialTerms& terms,
                    const NewtonStep& step, const VertexField& x) const;

  NewtonParameters parameters_;
  std::optional<SystemMatrix> matrix_;
  std::optional<SeparateStrands> separate_;
  std::optional<CoupledStrands> coupled_;
};

}  // namespace ringlet
