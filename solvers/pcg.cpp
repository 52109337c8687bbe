// Conjugate gradients with a preconditioner P (Hestenes, Stiefel 1952; Saad: Iterative Methods for
// Sparse Linear Systems, algorithm 9.1). Stops in the norm sqrt(r^T P^-1 r): in ||r|| the stiff
// stretching forces can satisfy a tolerance before the contacts feel anything.

#include <cmath>
#include <optional>

#include "core/linear_solver.h"
#include "core/registry.h"
#include "solvers/group_sum.h"

namespace ringlet {
namespace {

struct PcgParameters {
  double tolerance = 1e-6;
  int max_iterations = 1000;
  std::optional<Choice<LinearSolver>> preconditioner = Choice<LinearSolver>("strand_cholesky");

  static Schema<PcgParameters> schema() {
    return Schema<PcgParameters>()
        .key("tolerance", &PcgParameters::tolerance, "", positive(),
             "stop when sqrt(r^T P^-1 r) has fallen to this part of its start")
        .key("max_iterations", &PcgParameters::max_iterations, "", at_least(1),
             "cap; the step report tells when it is hit")
        .key("preconditioner", &PcgParameters::preconditioner, "", any_number(),
             "P: a solver that is close to the inverse and symmetric");
  }
};

class Pcg final : public LinearSolver {
 public:
  explicit Pcg(const PcgParameters& parameters) : parameters_(parameters) {
    if (parameters.preconditioner) preconditioner_ = parameters.preconditioner->make();
  }

  void bind(const StrandGroups& groups) override {
    sum_ = GroupSum(groups);
    residual_ = direction_ = product_ = VertexField(groups);
    if (preconditioner_) {
      preconditioned_ = VertexField(groups);
      preconditioner_->bind(groups);
    }
  }

  void prepare_group(const SystemMatrix& a, int group) override {
    if (preconditioner_) preconditioner_->prepare_group(a, group);
  }

  bool prepare(const SystemMatrix& a) override {
    matrix_ = &a;
    return !preconditioner_ || preconditioner_->prepare(a);
  }

  /// Where the matrix or the preconditioner turns out not to be positive definite, the last iterate
  /// is returned as not converged.
  SolveReport solve(const VertexField& b, VertexField& x) override {
    x.set_zero();
    residual_ = b;
    precondition();
    const double start = sum_.dot(residual_, preconditioned());
    SolveReport report{.converged = start == 0, .residual = start == 0 ? 0.0 : 1.0};
    if (!(start > 0) || !std::isfinite(start)) return report;

    direction_ = preconditioned();
    double squared_norm = start;
    while (report.iterations < parameters_.max_iterations) {
      multiply(*matrix_, direction_, product_);
      const double alpha = squared_norm / sum_.dot(direction_, product_);
      if (!(alpha > 0) || !std::isfinite(alpha)) break;
      ++report.iterations;
      add_scaled(x, alpha, direction_);
      add_scaled(residual_, -alpha, product_);
      precondition();
      const double next_squared_norm = sum_.dot(residual_, preconditioned());
      if (!(next_squared_norm >= 0) || !std::isfinite(next_squared_norm)) break;
      report.residual = std::sqrt(next_squared_norm / start);
      report.converged = report.residual <= parameters_.tolerance;
      if (report.converged) break;
      turn_direction(next_squared_norm / squared_norm);
      squared_norm = next_squared_norm;
    }
    return report;
  }

 private:
  void precondition() {
    if (preconditioner_) preconditioner_->apply(residual_, preconditioned_);
  }
  /// P^-1 r.
  const VertexField& preconditioned() const {
    return preconditioner_ ? preconditioned_ : residual_;
  }

  /// p = P^-1 r + beta p.
  void turn_direction(double beta) {
    const StrandGroups& groups = direction_.groups();
    parallel_for_each(groups.count(), [&](int g) {
      const auto p = direction_.group(g);
      const auto z = preconditioned().group(g);
      for (std::size_t i = 0; i < p.size(); ++i) p[i] = z[i] + Pack(beta) * p[i];
    });
  }

  PcgParameters parameters_;
  std::unique_ptr<LinearSolver> preconditioner_;
  const SystemMatrix* matrix_ = nullptr;
  GroupSum sum_;
  VertexField residual_, preconditioned_, direction_, product_;
};

}  // namespace

void register_pcg(Registry& registry) {
  registry.of<LinearSolver>().add<PcgParameters>(
      "pcg",
      {"preconditioned conjugate gradients; for scenes with contacts", "min x^T A x / 2 - b^T x",
       "Saad: Iterative Methods for Sparse Linear Systems, algorithm 9.1"},
      [](const PcgParameters& parameters) { return std::make_unique<Pcg>(parameters); });
}

}  // namespace ringlet
