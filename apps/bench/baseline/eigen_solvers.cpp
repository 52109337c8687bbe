#include "apps/bench/baseline/eigen_solvers.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>

#include "apps/bench/baseline/sparse_matrix.h"
#include "core/linear_solver.h"

namespace ringlet {
namespace {

struct EigenCgParameters {
  double tolerance = 1e-6;

  static Schema<EigenCgParameters> schema() {
    return Schema<EigenCgParameters>().key("tolerance", &EigenCgParameters::tolerance, "",
                                           positive(), "stop when |b - A x| is this part of |b|");
  }
};

struct EigenLdltParameters {
  static Schema<EigenLdltParameters> schema() { return {}; }
};

/// A solver of Eigen, set up anew for every matrix. SolverOfEigen has compute(A), solve(b), info().
template <class SolverOfEigen>
class EigenSolver : public LinearSolver {
 public:
  void bind(const StrandGroups&) override {}

  bool prepare(const SystemMatrix& a) override {
    matrix_ = sparse_matrix(a);
    solver_.compute(matrix_);
    return solver_.info() == Eigen::Success;
  }

  SolveReport solve(const VertexField& b, VertexField& x) override {
    const Eigen::Matrix3Xd columns = b.matrix();
    const Eigen::VectorXd right = columns.reshaped();
    const Eigen::VectorXd solution = solver_.solve(right);
    x.set_zero();
    x.set_matrix(solution.reshaped(3, columns.cols()));
    return report();
  }

 protected:
  virtual SolveReport report() const { return {}; }

  SolverOfEigen solver_;

 private:
  Eigen::SparseMatrix<double> matrix_;
};

using ConjugateGradient =
    Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper>;

class EigenCg final : public EigenSolver<ConjugateGradient> {
 public:
  explicit EigenCg(const EigenCgParameters& parameters) {
    solver_.setTolerance(parameters.tolerance);
  }

 private:
  SolveReport report() const override {
    return {.iterations = static_cast<int>(solver_.iterations()),
            .converged = solver_.info() == Eigen::Success,
            .residual = solver_.error()};
  }
};

}  // namespace

void register_eigen_cg(Registry& registry) {
  registry.of<LinearSolver>().add<EigenCgParameters>(
      "eigen_cg", {"the baseline's conjugate gradients", "", "Eigen"},
      [](const EigenCgParameters& parameters) { return std::make_unique<EigenCg>(parameters); });
}

void register_eigen_ldlt(Registry& registry) {
  using Ldlt = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>;
  registry.of<LinearSolver>().add<EigenLdltParameters>(
      "eigen_ldlt", {"the baseline's factorisation", "A = L D L^T", "Eigen"},
      [](const EigenLdltParameters&) { return std::make_unique<EigenSolver<Ldlt>>(); });
}

}  // namespace ringlet
