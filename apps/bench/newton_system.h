#pragma once

#include "core/incremental_potential.h"
#include "core/simulation.h"

namespace ringlet {

/// The system of the first Newton iteration of the next step of a simulation.
class NewtonSystem {
 public:
  /// The simulation must outlive it.
  NewtonSystem(const Simulation& simulation, double dt);

  const Model& model() const { return model_; }
  int contacts() const;
  /// Evaluates everything, each group's matrix going to the solver when complete.
  void assemble(LinearSolver& solver, SystemMatrix& matrix, VertexField& gradient,
                VertexField& solution) const;

 private:
  const Model& model_;
  VertexField x_, target_;
  double dt_;
};

}  // namespace ringlet
