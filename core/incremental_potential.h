#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/model.h"
#include "core/system_matrix.h"

namespace ringlet {

/// The parts of the value of an incremental potential, J.
struct PotentialTerms {
  double inertia = 0;
  std::vector<double> energies;   ///< of each elastic term
  std::vector<double> couplings;  ///< of each term between strands
  double forces = 0;
  double contacts = 0;

  double total() const;
  /// The sum of their absolute values: the scale of the rounding errors in total().
  double magnitude() const;
};

/// What a time step minimises (math.md, section 6):
///
///     Phi(x) = (x - y)^T M (x - y) / (2 h^2) + energies + couplings + forces + contacts
///
/// y is the inertial target, h the effective time step: for BDF-1 y = x_n + dt v_n and h = dt. With
/// an infinite h there is no inertia.
/// Pinned vertices are not unknowns: they stand where x has them. Keeps the memory of its sums
/// between calls.
class IncrementalPotential {
 public:
  /// All references must outlive the potential.
  IncrementalPotential(const Model& model, const VertexField& inertial_target, double h);

  /// Another effective time step, s.
  void set_effective_step(double h) { inverse_h2_ = 1 / (h * h); }

  void value(const VertexField& x, PotentialTerms& terms);
  std::size_t bytes() const {
    return bytes_of(terms_of_groups_) + bytes_of(of_groups_) + bytes_of(coupling_values_);
  }

  /// Collects the couplings at x, and the contacts that the collision stage has detected, in the
  /// matrix. Before assemble(), where the model may couple.
  void couple(const VertexField& x, SystemMatrix& matrix);
  /// What assemble() computes, beside what it writes.
  struct Assembled {
    PotentialTerms terms;
    double squared_gradient = 0;  ///< |grad Phi|^2, N^2
    bool usable = false;          ///< for the linear solver, as far as prepare_rows() tells
  };
  /// Value, gradient and filtered Hessian A plus `added` M, with the matrix's couplings; gradient
  /// is zero and the matrix identity at pinned vertices. Each group's bands are handed to the
  /// solver's prepare_rows() when complete, which may already solve A x = gradient into the
  /// direction; but for a solver with a band factor not those of groups where nothing is free.
  void assemble(const VertexField& x, VertexField& gradient, SystemMatrix& matrix,
                LinearSolver& solver, VertexField& direction, Assembled& result, double added = 0);

  // One group at a time, from several threads at once for different ones. All groups together are
  // the whole where nothing couples strands.
  using Rows = std::span<Vector3<Pack>>;
  using ConstRows = std::span<const Vector3<Pack>>;
  /// What a group is assembled from, and to.
  struct GroupRows {
    ConstRows x;
    Rows gradient, direction;
    double added = 0;
  };
  /// What assemble_group() computes, beside what it writes.
  struct GroupAssembled {
    double squared_gradient = 0;
    bool usable = false;
  };
  /// Finds terms_of(group) at x.
  void value_of_group(int group, ConstRows x);
  /// As assemble(), with the matrix's temporary bands for a solver with a band factor.
  GroupAssembled assemble_group(int group, const GroupRows& rows, SystemMatrix& matrix,
                                LinearSolver& solver);
  /// The terms of a group where it was last evaluated, J: inertia, energies, the sum of the forces.
  std::span<const double> terms_of(int group) const {
    return std::span(terms_of_groups_).subspan(group * term_count(), term_count());
  }
  /// Their sums over the groups; couplings and contacts as they were last evaluated.
  void sum_terms(PotentialTerms& total) const;

 private:
  double inertia(int group, ConstRows x) const;
  void add_energies(int group, ConstRows x, EdgeOutputs outputs, std::span<double> terms) const;
  template <class IsWanted>
  void add_forces(int group, ConstRows x, GroupOutputs outputs, std::span<double> terms,
                  const IsWanted& is_wanted) const;
  PinnedRows pinned_rows(int group) const;
  /// Of the calls for a group: the clock is looked at in some of them, since that takes as long as
  /// some elements.
  TimeSample sample_of(int group) const;
  std::size_t term_count() const { return model_.energies.size() + 2; }
  std::span<double> writable_terms(int group) {
    return std::span(terms_of_groups_).subspan(group * term_count(), term_count());
  }
  /// Whether nothing in a group but edges and masses has a Hessian: the rows of its matrix are then
  /// complete one after the other.
  bool has_edges_only(int group, const Couplings& couplings) const;
  /// Inertia, whose value is returned, and energies: adds to rows of the gradient, and writes those
  /// of the Hessian.
  double write_rows(int group, RowRange range, const GroupRows& rows, EdgeDerivatives& edges,
                    GroupBands hessian) const;
  /// Hands complete rows to the solver, unless it has refused some before.
  void prepare_rows(const GroupSystem& system, RowRange range, const GroupRows& rows,
                    LinearSolver& solver, GroupAssembled& result) const;
  /// Values of couplings and contacts; what they add goes where it is wanted.
  void add_coupled(const VertexField& x, Couplings* couplings);

  const Model& model_;
  const VertexField& target_;
  double inverse_h2_ = 0;
  std::vector<double> terms_of_groups_;  // term_count() of each
  std::vector<GroupAssembled> of_groups_;
  std::vector<double> coupling_values_;  ///< of each coupling, where they were last added
  double contact_value_ = 0;
};

/// Says in words where something is not finite: the first vertex whose position is not, or the
/// first term of the potential with a value, gradient or Hessian that is not. Nothing if all is
/// finite. Slow; for error messages.
std::optional<std::string> find_non_finite(const Model& model, const VertexField& x);

}  // namespace ringlet
