#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <vector>

#include "core/linear_solver.h"
#include "solvers/group_sum.h"

namespace ringlet {

/// Conjugate gradients for A = B + C, where the bands B of the strands have a factor and C couples
/// strands. With B as the preconditioner, and B^-1 b as the first iterate, everything but the
/// iterate itself is zero where C has no rows:
///
///     r_0 = b - A B^-1 b = -C B^-1 b,    B p_k = r_k + beta B p_{k-1},    A p = B p + C p
///
/// so that vectors have an entry a coupled vertex, there is no product with B, and the iterate is
/// found at the end, x = B^-1 (b + sum of alpha B p). An iteration is a substitution with the
/// factor, and little else.
class CoupledGradients {
 public:
  struct Stop {
    double tolerance;  ///< of sqrt(r^T B^-1 r), relative to that of b
    int max_iterations;
  };

  void bind(const StrandGroups& groups);
  /// x holds B^-1 b at its beginning. Where A turns out not to be positive definite, the last
  /// iterate is returned as not converged.
  SolveReport solve(const BandFactor& factor, const Couplings& couplings, const VertexField& b,
                    VertexField& x, const Stop& stop);

  std::size_t bytes() const;

 private:
  using Vectors = StreamedVector<Vector3<double>>;

  double squared_norm(const VertexField& b, const VertexField& x);
  double begin(const VertexField& x);
  double precondition(int group);
  void turn_direction(double beta);
  double multiply_direction();
  double go(double alpha);
  void finish(VertexField& x);
  std::span<Vector3<Pack>> rows_with(const Vectors& values, int group);
  template <class Body>
  void for_coupled(const Body& body) const;
  template <class Body>
  double sum_coupled(const Body& body);

  const StrandGroups* groups_ = nullptr;
  const BandFactor* factor_ = nullptr;
  const Couplings* couplings_ = nullptr;
  GroupSum sum_;
  // r, z = B^-1 r, p, B p, C p, and the sum of alpha B p, at the coupled vertices.
  Vectors residual_, preconditioned_, direction_, band_product_, coupling_product_, right_side_;
  StreamedVector<LaneSlot> slots_;  // where they stand in the rows of their group
  tbb::enumerable_thread_specific<std::vector<Vector3<Pack>>> temporary_;
};

}  // namespace ringlet
