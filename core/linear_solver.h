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

/// The part of A x = b that belongs to the strands of one group.
struct GroupSystem {
  int group;
  GroupBands bands;  ///< A without what couples strands
  std::span<const Vector3<Pack>> b;
  bool coupled;  ///< whether blocks outside the bands touch these strands
};

/// Solves A x = b for the symmetric matrix of a Newton step. A solver can be the preconditioner of
/// another one. Usage a Newton iteration: prepare_group() for every group, prepare(), solve()...
class LinearSolver {
 public:
  virtual ~LinearSolver() = default;

  /// Allocates what matrices of these groups need. Called once.
  virtual void bind(const StrandGroups& groups) = 0;
  /// Whether the solver reads the bands of the matrix after prepare_group(). If not, it may
  /// overwrite there what it is given, and has to keep what it needs: the bands of a group that is
  /// not coupled are gone afterwards, those of the others stay as it leaves them. Its apply() is
  /// then the exact inverse of A without its couplings.
  virtual bool keeps_bands() const { return true; }
  /// Called as soon as the system of a group is complete, while it is warm in cache; from several
  /// threads at once, for different groups. A band solver factors here. Where the group is not
  /// coupled it may also write its part of the solution to x, and return true.
  virtual bool prepare_group(const GroupSystem& system, std::span<Vector3<Pack>> x) {
    (void)system, (void)x;
    return false;
  }
  /// Called when all groups are complete. Returns false if the matrix cannot be used (a pivot that
  /// is not positive); solve() must not be called then.
  virtual bool prepare(const SystemMatrix& a) = 0;
  /// x = A^-1 b, where x holds what prepare_group() wrote for the same b. The matrix given to
  /// prepare() is still alive and, but for what prepare_group() overwrote, unchanged.
  virtual SolveReport solve(const VertexField& b, VertexField& x) = 0;
  /// z = P^-1 r, P symmetric positive definite and close to A: what a preconditioner does. Unlike
  /// solve(), it neither iterates nor reports where a fixed approximation is at hand. Groups of
  /// which prepare_group() has written the solution are left alone.
  virtual void apply(const VertexField& r, VertexField& z) { solve(r, z); }
};

}  // namespace ringlet
