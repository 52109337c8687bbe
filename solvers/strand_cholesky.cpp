// Block-banded Cholesky factorisation of every strand, strands side by side in lanes. Exact where
// no contact couples strands; else it solves with the strands' own blocks, those of contacts within
// the bands included, and leaves the couplings out. Golub, Van Loan: Matrix Computations, 4.3.5.

#include <algorithm>
#include <cmath>

#include "core/linear_solver.h"
#include "core/parallel.h"
#include "core/registry.h"
#include "solvers/band_cholesky.h"
#include "solvers/kept_factors.h"

namespace ringlet {
namespace {

struct StrandCholeskyParameters {
  static Schema<StrandCholeskyParameters> schema() { return {}; }
};

class StrandCholesky final : public LinearSolver, private BandFactor {
 public:
  void set_tolerance(double tolerance) override { tolerance_ = tolerance; }

  void bind(const StrandGroups& groups) override {
    groups_ = &groups;
    factors_.bind(groups, tolerance_);
  }

  std::size_t bytes() const override { return factors_.bytes(); }
  const BandFactor* band_factor() const override { return this; }

  bool prepare_rows(const GroupSystem& system, RowRange rows, std::span<Vector3<Pack>> x) override {
    std::copy_n(&system.b[rows.first], rows.count(), &x[rows.first]);
    if (!factor_rows(system.bands, rows, x)) return false;
    if (rows.end < system.bands.rows()) return true;
    substitute_back(system.bands, x);
    if (system.coupled) factors_.keep(system.group, system.bands, system.b, x);
    return true;
  }

  bool prepare(const SystemMatrix& a) override {
    matrix_ = &a;
    return true;
  }

  SolveReport solve(const VertexField& b, VertexField& x) override {
    if (!matrix_->couples_strands()) return {};
    return {.converged = false, .residual = relative_residual(b, x)};
  }

 private:
  void solve_group(int group, int first, std::span<Vector3<Pack>> x) const override {
    factors_.solve(group, first, x);
  }

  /// ||b - A x|| / ||b||: what is left are the couplings.
  double relative_residual(const VertexField& b, const VertexField& x) const {
    VertexField product(*groups_);
    parallel_for_each(groups_->count(),
                      [&](int g) { matrix_->couplings.add_product(g, x, product); });
    const double norm = std::sqrt(dot(b, b));
    return norm > 0 ? std::sqrt(dot(product, product)) / norm : 0;
  }

  const StrandGroups* groups_ = nullptr;
  const SystemMatrix* matrix_ = nullptr;
  double tolerance_ = 0;
  KeptFactors factors_;  // of coupled groups
};

}  // namespace

void register_strand_cholesky(Registry& registry) {
  registry.of<LinearSolver>().add<StrandCholeskyParameters>(
      "strand_cholesky",
      {"banded Cholesky factorisation of each strand; exact if contacts couple no strands",
       "A = L L^T, a strand", "Golub, Van Loan: Matrix Computations, section 4.3.5"},
      [](const StrandCholeskyParameters&) { return std::make_unique<StrandCholesky>(); });
}

}  // namespace ringlet
