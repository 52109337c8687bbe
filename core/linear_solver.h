#pragma once

#include <string>

#include "core/named.h"
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

/// A factor of the strands' bands B: of A without what couples strands.
class BandFactor {
 public:
  virtual ~BandFactor() = default;
  /// x = B^-1 x for the rows of one coupled group. Where x is zero before row `first` of the group,
  /// it may be left undefined there. Thread-safe for different x.
  virtual void solve_group(int group, int first, std::span<Vector3<Pack>> x) const = 0;
};

/// Solves A x = b for the symmetric matrix of a Newton step. A solver can be the preconditioner of
/// another one. Usage a Newton iteration: prepare_rows() for all rows, prepare(), solve()... Where
/// nothing couples strands, one with a band factor has solved in prepare_rows(), and nothing else
/// is called.
class LinearSolver : public Named {
 public:
  virtual ~LinearSolver() = default;

  /// Called before bind() by a solver that preconditions with this one and stops at this tolerance:
  /// a preconditioner that is exact but for an error well below it may save time by that.
  virtual void set_tolerance(double) {}
  /// Allocates what matrices of these groups need. Called once.
  virtual void bind(const StrandGroups& groups) = 0;
  /// Not null: the solver turns the bands of each group into this factor in prepare_rows(), and
  /// solves there with it. Nobody else reads the bands: it may factor them in their place, and they
  /// are gone when it returns from the last of them.
  virtual const BandFactor* band_factor() const { return nullptr; }
  /// Called as soon as the next rows of the system of a group are complete, while they are warm in
  /// cache, from the root to the tip; from several threads at once, for different groups. A solver
  /// with a band factor makes it here, and has written x = B^-1 b when it returns from the last
  /// rows; groups in which nothing is free, and whose x is zero, it does not see. Returns false if
  /// the matrix cannot be used (a pivot that is not positive): no more rows of this group follow.
  virtual bool prepare_rows(const GroupSystem& system, RowRange rows, std::span<Vector3<Pack>> x) {
    (void)system, (void)rows, (void)x;
    return true;
  }
  /// Called when all groups are complete and could be used. Returns false if the matrix cannot;
  /// solve() must not be called then.
  virtual bool prepare(const SystemMatrix& a) = 0;
  /// x = A^-1 b, where x holds what prepare_rows() wrote for the same b. The matrix given to
  /// prepare() is still alive and, but for what prepare_rows() overwrote, unchanged.
  virtual SolveReport solve(const VertexField& b, VertexField& x) = 0;
  /// z = P^-1 r, P symmetric positive definite and close to A: what a preconditioner without a band
  /// factor does. Unlike solve(), it neither iterates nor reports where a fixed approximation is at
  /// hand.
  virtual void apply(const VertexField& r, VertexField& z) { solve(r, z); }
  /// Of a solver that chooses how it solves: what it chose so far, and why. Else empty.
  virtual std::string account() const { return {}; }
};

}  // namespace ringlet
