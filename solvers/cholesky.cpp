// Sparse direct solution, A = L L^T with a fill-reducing order of the unknowns (approximate minimum
// degree; Davis: Direct Methods for Sparse Linear Systems). The ordering is computed anew only when
// the pattern of the contacts changes.

#include <Eigen/SparseCholesky>
#include <algorithm>

#include "core/linear_solver.h"
#include "core/registry.h"

namespace ringlet {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

struct CholeskyParameters {
  static Schema<CholeskyParameters> schema() { return {}; }
};

bool same_pattern(const SparseMatrix& a, const SparseMatrix& b) {
  return a.rows() == b.rows() && a.nonZeros() == b.nonZeros() &&
         std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.outerSize() + 1, b.outerIndexPtr()) &&
         std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}

class Cholesky final : public LinearSolver {
 public:
  void bind(const StrandGroups& groups) override { groups_ = &groups; }
  std::size_t bytes() const override {
    constexpr std::size_t entry = sizeof(double) + sizeof(int);
    const Eigen::Index in_factor =
        analysed_ ? factor_.matrixL().nestedExpression().nonZeros() : Eigen::Index(0);
    return bytes_of(entries_) + entry * static_cast<std::size_t>(lower_.nonZeros() + in_factor);
  }

  bool prepare(const SystemMatrix& a) override {
    SparseMatrix lower = lower_triangle(a);
    const bool known = same_pattern(lower, lower_);
    lower_.swap(lower);
    if (!Eigen::Map<const Eigen::ArrayXd>(lower_.valuePtr(), lower_.nonZeros()).allFinite()) {
      return false;
    }
    if (!known || !analysed_) factor_.analyzePattern(lower_);
    analysed_ = true;
    factor_.factorize(lower_);
    return factor_.info() == Eigen::Success;
  }

  SolveReport solve(const VertexField& b, VertexField& x) override {
    const Eigen::Matrix3Xd columns = b.matrix();
    const Eigen::VectorXd solution = factor_.solve(columns.reshaped());
    x.set_zero();
    x.set_matrix(solution.reshaped(3, columns.cols()));
    return {};
  }

 private:
  /// The lower triangle over the unknowns of all vertices, without the pads.
  SparseMatrix lower_triangle(const SystemMatrix& a) {
    entries_.clear();
    for (int row = 0; row < groups_->rows(); ++row) {
      for (int lane = 0; lane < lane_count; ++lane) add_band_row(a.bands, row, lane);
    }
    a.couplings.for_each_off_band([&](int i, int j, const Eigen::Matrix3d& block) {
      if (i > j) add_block(i, j, [&](int r, int c) { return block(r, c); });
    });
    const int size = 3 * groups_->vertex_count();
    SparseMatrix lower(size, size);
    lower.setFromTriplets(entries_.begin(), entries_.end());
    return lower;
  }

  void add_band_row(const StrandBands& bands, int row, int lane) {
    const int vertex = groups_->vertex_at(row, lane);
    if (vertex < 0) return;
    const int left =
        std::min(row - (*groups_)[groups_->group_of(vertex)].first_row, band_blocks - 1);
    for (int k = 0; k <= left; ++k) {
      const Matrix3<Pack>& block = bands.block(row, k);
      add_block(vertex, vertex - k, [&](int r, int c) { return block(r, c)[lane]; });
    }
  }

  template <class Block>
  void add_block(int i, int j, const Block& block) {
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < (i == j ? r + 1 : 3); ++c) {
        entries_.emplace_back(3 * i + r, 3 * j + c, block(r, c));
      }
    }
  }

  const StrandGroups* groups_ = nullptr;
  std::vector<Eigen::Triplet<double>> entries_;
  SparseMatrix lower_;
  bool analysed_ = false;
  Eigen::SimplicialLLT<SparseMatrix, Eigen::Lower, Eigen::AMDOrdering<int>> factor_;
};

}  // namespace

void register_cholesky(Registry& registry) {
  registry.of<LinearSolver>().add<CholeskyParameters>(
      "cholesky",
      {"sparse direct factorisation, contacts included; for small scenes and as a reference",
       "A = L L^T", "Davis: Direct Methods for Sparse Linear Systems"},
      [](const CholeskyParameters&) { return std::make_unique<Cholesky>(); });
}

}  // namespace ringlet
