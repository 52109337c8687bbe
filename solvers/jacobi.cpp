// Damped block Jacobi iteration, x += w D^-1 (b - A x), D being the 3x3 diagonal blocks of A; as a
// preconditioner z = D^-1 r. Saad: Iterative Methods for Sparse Linear Systems, sections 4.1, 10.2.
//
// A is a sum of positive semi-definite terms over four vertices each (dihedrals, pairs of edges in
// contact) or fewer, and of the masses. For such a term A_e and the diagonal blocks D_e of it,
// A_e <= 4 D_e. Hence no eigenvalue of D^-1 A exceeds 4, and the iteration converges for w < 1/2.

#include <cmath>

#include "core/linear_solver.h"
#include "core/registry.h"
#include "solvers/block_cholesky.h"
#include "solvers/group_sum.h"

namespace ringlet {
namespace {

struct JacobiParameters {
  double tolerance = 1e-6;
  int max_iterations = 10000;
  double weight = 0.45;

  static Schema<JacobiParameters> schema() {
    return Schema<JacobiParameters>()
        .key("tolerance", &JacobiParameters::tolerance, "", positive(),
             "stop when sqrt(r^T D^-1 r) has fallen to this part of its start; not used as a "
             "preconditioner")
        .key("max_iterations", &JacobiParameters::max_iterations, "", at_least(1),
             "cap; not used as a preconditioner")
        .key("weight", &JacobiParameters::weight, "", positive(),
             "w, of an update; below 0.5 convergence is certain; not used as a preconditioner");
  }
};

class Jacobi final : public LinearSolver {
 public:
  explicit Jacobi(const JacobiParameters& parameters) : parameters_(parameters) {}

  void bind(const StrandGroups& groups) override {
    groups_ = &groups;
    sum_ = GroupSum(groups);
    inverse_.resize(groups.rows());
  }
  std::size_t bytes() const override {
    return bytes_of(inverse_) + residual_.bytes() + update_.bytes() + next_.bytes();
  }

  bool prepare_rows(const GroupSystem& system, RowRange rows, std::span<Vector3<Pack>>) override {
    Mask bad(false);
    InverseTriangle* inverse = &inverse_[(*groups_)[system.group].first_row];
    for (int i = rows.first; i < rows.end; ++i) {
      inverse[i] = inverse_cholesky(lower_triangle(system.bands.block(i, 0)), bad);
    }
    return !any(bad);
  }

  bool prepare(const SystemMatrix& a) override {
    matrix_ = &a;
    return true;
  }

  void apply(const VertexField& r, VertexField& z) override { precondition(r, z); }

  SolveReport solve(const VertexField& b, VertexField& x) override {
    if (residual_.rows().empty()) residual_ = update_ = next_ = VertexField(*groups_);
    x.set_zero();
    residual_ = b;
    const double start = precondition(residual_, update_);
    SolveReport report{.converged = start == 0, .residual = start > 0 ? 1.0 : 0.0};
    double squared_norm = start;
    while (!report.converged && report.iterations < parameters_.max_iterations) {
      multiply(*matrix_, update_, next_);
      add_scaled(residual_, -parameters_.weight, next_);
      const double next_squared_norm = precondition(residual_, next_);
      // In this norm a converging iteration never grows.
      if (!(next_squared_norm <= squared_norm)) break;
      add_scaled(x, parameters_.weight, update_);
      std::swap(update_, next_);
      squared_norm = next_squared_norm;
      ++report.iterations;
      report.residual = std::sqrt(squared_norm / start);
      report.converged = report.residual <= parameters_.tolerance;
    }
    return report;
  }

 private:
  /// z = D^-1 r; returns r^T z.
  double precondition(const VertexField& r, VertexField& z) {
    return sum_([&](int g) {
      const auto rows_r = r.group(g);
      const auto rows_z = z.group(g);
      const InverseTriangle* inverse = &inverse_[(*groups_)[g].first_row];
      Pack sum = 0;
      for (std::size_t i = 0; i < rows_r.size(); ++i) {
        rows_z[i] = transpose_multiply(inverse[i], inverse[i] * rows_r[i]);
        sum += dot(rows_r[i], rows_z[i]);
      }
      return sum_lanes(sum);
    });
  }

  JacobiParameters parameters_;
  const StrandGroups* groups_ = nullptr;
  const SystemMatrix* matrix_ = nullptr;
  GroupSum sum_;
  std::vector<InverseTriangle> inverse_;
  VertexField residual_, update_, next_;  // only as a solver
};

}  // namespace

void register_jacobi(Registry& registry) {
  registry.of<LinearSolver>().add<JacobiParameters>(
      "jacobi",
      {"damped iteration with the inverses of the diagonal blocks; slow, but a cheap "
       "preconditioner",
       "x += w D^-1 (b - A x)", "Saad: Iterative Methods for Sparse Linear Systems, section 4.1"},
      [](const JacobiParameters& parameters) { return std::make_unique<Jacobi>(parameters); });
}

}  // namespace ringlet
