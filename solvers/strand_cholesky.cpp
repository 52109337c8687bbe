// Block-banded Cholesky factorisation of every strand, eight strands in lanes. Exact where no
// contact couples strands; else it solves with the strands' own blocks, those of contacts within
// the bands included, and leaves the couplings out. Golub, Van Loan: Matrix Computations, 4.3.5.

#include <algorithm>
#include <cmath>

#include "core/linear_solver.h"
#include "core/parallel.h"
#include "core/registry.h"
#include "solvers/band_cholesky.h"

namespace ringlet {
namespace {

struct StrandCholeskyParameters {
  static Schema<StrandCholeskyParameters> schema() { return {}; }
};

class StrandCholesky final : public LinearSolver {
 public:
  void bind(const StrandGroups& groups) override {
    groups_ = &groups;
    factor_.resize(groups.rows());
    positive_.assign(groups.count(), false);
  }

  void prepare_group(const SystemMatrix& a, int group) override {
    positive_[group] = factor_bands(a.bands, group, factor(group));
  }

  bool prepare(const SystemMatrix& a) override {
    matrix_ = &a;
    return std::find(positive_.begin(), positive_.end(), false) == positive_.end();
  }

  void apply(const VertexField& r, VertexField& z) override {
    parallel_for_each(groups_->count(),
                      [&](int g) { solve_bands(factor(g), r.group(g), z.group(g)); });
  }

  SolveReport solve(const VertexField& b, VertexField& x) override {
    apply(b, x);
    if (!matrix_->couples_strands()) return {};
    return {.converged = false, .residual = relative_residual(b, x)};
  }

 private:
  std::span<BandFactorRow> factor(int group) {
    const StrandGroup& g = (*groups_)[group];
    return std::span(factor_).subspan(g.first_row, g.vertices);
  }

  /// ||b - A x|| / ||b||.
  double relative_residual(const VertexField& b, const VertexField& x) {
    if (residual_.rows().empty()) residual_ = VertexField(*groups_);
    multiply(*matrix_, x, residual_);
    add_scaled(residual_, -1, b);
    const double norm = std::sqrt(dot(b, b));
    return norm > 0 ? std::sqrt(dot(residual_, residual_)) / norm : 0;
  }

  const StrandGroups* groups_ = nullptr;
  const SystemMatrix* matrix_ = nullptr;
  std::vector<BandFactorRow> factor_;
  std::vector<char> positive_;  // not vector<bool>: threads write neighbours at once
  VertexField residual_;        // only where couplings are left out
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
