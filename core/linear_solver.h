#pragma once

#include "core/system_matrix.h"

namespace ringlet {

/// What a linear solver says about one solve. Hitting an iteration cap is not silent.
struct SolveReport {
  int iterations = 0;  ///< 0 for a direct solver
  bool converged = true;
  double residual = 0;  ///< in the norm in which the solver stops, relative to its start; 0 where
                        ///< a direct solver has no reason to look
};

/// Solves A x = b for the symmetric matrix of a Newton step. A solver can be the preconditioner of
/// another one. Usage a Newton iteration: prepare_group() for every group, prepare(), solve()...
class LinearSolver {
 public:
  virtual ~LinearSolver() = default;

  /// Allocates what matrices of these groups need. Called once.
  virtual void bind(const StrandGroups& groups) = 0;
  /// Called as soon as the bands of a group are complete, while they are warm in cache; from
  /// several threads at once, for different groups. A band solver factors here.
  virtual void prepare_group(const SystemMatrix& a, int group) { (void)a, (void)group; }
  /// Called when all groups are complete. Returns false if the matrix cannot be used (a pivot that
  /// is not positive); solve() must not be called then.
  virtual bool prepare(const SystemMatrix& a) = 0;
  /// x = A^-1 b. The matrix given to prepare() is still alive and unchanged.
  virtual SolveReport solve(const VertexField& b, VertexField& x) = 0;
  /// z = P^-1 r, P symmetric positive definite and close to A: what a preconditioner does. Unlike
  /// solve(), it neither iterates nor reports where a fixed approximation is at hand.
  virtual void apply(const VertexField& r, VertexField& z) { solve(r, z); }
};

}  // namespace ringlet
