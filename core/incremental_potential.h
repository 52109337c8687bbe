#pragma once

#include <functional>
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
    return bytes_of(terms_of_groups_) + bytes_of(squared_gradients_) + bytes_of(coupling_values_);
  }

  /// Collects the couplings at x, and the contacts that the collision stage has detected, in the
  /// matrix. Before assemble(), where the model may couple.
  void couple(const VertexField& x, SystemMatrix& matrix);
  /// What assemble() computes, beside what it writes.
  struct Assembled {
    PotentialTerms terms;
    double squared_gradient = 0;  ///< |grad Phi|^2, N^2
  };
  /// Value, gradient and filtered Hessian A plus `added` M, with the matrix's couplings; gradient
  /// is zero and the matrix identity at pinned vertices. Each group's bands are handed to the
  /// solver's prepare_group() when complete, which may already solve A x = gradient into the
  /// direction; but for a solver with a band factor not those of groups where nothing is free.
  void assemble(const VertexField& x, VertexField& gradient, SystemMatrix& matrix,
                LinearSolver& solver, VertexField& direction, Assembled& result, double added = 0);
  /// What belongs to one group, solved.
  struct SolvedGroup {
    int group;
    std::span<const Vector3<Pack>> gradient, direction;
  };
  /// The same where the model may not couple strands, for a solver with a band factor: gradient and
  /// direction are not kept, but those of each group shown to `see` while they are warm in cache;
  /// from several threads at once.
  void solve_groups(const VertexField& x, SystemMatrix& matrix, LinearSolver& solver,
                    const std::function<void(const SolvedGroup&)>& see, Assembled& result,
                    double added = 0);

 private:
  double inertia(int group, const VertexField& x) const;
  /// Of one group: inertia, the energies, and the sum of the forces.
  void add_energies(int group, const VertexField& x, EdgeOutputs outputs,
                    std::span<double> terms) const;
  template <class IsWanted>
  void add_forces(int group, const VertexField& x, GroupOutputs outputs, std::span<double> terms,
                  const IsWanted& is_wanted) const;
  /// All of these values.
  void add_values(int group, const VertexField& x);
  std::span<const Pack> free_of(int group) const;
  /// Of the calls for a group: the clock is looked at in some of them, since that takes as long as
  /// some elements.
  TimeSample sample_of(int group) const;
  std::size_t term_count() const { return model_.energies.size() + 2; }
  std::span<double> terms_of(int group) {
    return std::span(terms_of_groups_).subspan(group * term_count(), term_count());
  }
  /// What the groups are assembled for.
  struct Assembly {
    const VertexField& x;
    SystemMatrix& matrix;
    LinearSolver& solver;
    double mass_weight;  ///< of M in the Hessian, 1/s^2
  };
  /// Writes the gradient of a group, and what the solver solves.
  void assemble_group(int group, const Assembly& assembly, std::span<Vector3<Pack>> gradient,
                      std::span<Vector3<Pack>> direction);
  /// Whether nothing in a group but edges and masses has a Hessian: the rows of its matrix are then
  /// complete one after the other.
  bool has_edges_only(int group, const Couplings& couplings) const;
  /// Inertia, whose value is returned, and energies: adds to rows of the gradient, and writes those
  /// of the Hessian.
  double write_rows(int group, RowRange range, const Assembly& assembly, EdgeDerivatives& edges,
                    const GroupOutputs& outputs) const;
  /// Hands complete rows to the solver.
  void prepare_rows(const GroupSystem& system, RowRange rows, LinearSolver& solver,
                    const GroupOutputs& outputs, std::span<Vector3<Pack>> direction);
  void sum_groups(Assembled& result);
  void sum_terms(PotentialTerms& total);
  /// Values of couplings and contacts; what they add goes where it is wanted.
  void add_coupled(const VertexField& x, Couplings* couplings);

  const Model& model_;
  const VertexField& target_;
  double inverse_h2_ = 0;
  std::vector<double> terms_of_groups_;  // term_count() of each
  std::vector<double> squared_gradients_;
  std::vector<double> coupling_values_;  ///< of each coupling, where they were last added
  double contact_value_ = 0;
};

/// Says in words where something is not finite: the first vertex whose position is not, or the
/// first term of the potential with a value, gradient or Hessian that is not. Nothing if all is
/// finite. Slow; for error messages.
std::optional<std::string> find_non_finite(const Model& model, const VertexField& x);

}  // namespace ringlet
