// Conjugate gradients with a preconditioner P (Hestenes, Stiefel 1952; Saad: Iterative Methods for
// Sparse Linear Systems, algorithm 9.1). Stops in the norm sqrt(r^T P^-1 r): in ||r|| the stiff
// stretching forces can satisfy a tolerance before the contacts feel anything.

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "core/linear_solver.h"
#include "core/registry.h"
#include "solvers/coupled_gradients.h"

namespace ringlet {
namespace {

struct PcgParameters {
  // Tighter ones cost more and bring the end of a step no nearer to where Newton's method would end
  // (measured on the hairball): the next iteration makes up for the rest. With 0.1 it does not.
  double tolerance = 3e-2;
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
    if (!parameters.preconditioner) return;
    preconditioner_ = parameters.preconditioner->make();
    preconditioner_->set_tolerance(parameters.tolerance);
  }

  void bind(const StrandGroups& groups) override {
    if (preconditioner_) naming(*preconditioner_, [&] { preconditioner_->bind(groups); });
    coupled_.bind(groups);
    if (band_factor() != nullptr) return;
    sum_ = GroupSum(groups);
    residual_ = direction_ = product_ = VertexField(groups);
    if (preconditioner_) preconditioned_ = VertexField(groups);
  }

  std::size_t bytes() const override {
    std::size_t sum = coupled_.bytes() + (preconditioner_ ? preconditioner_->bytes() : 0);
    for (const VertexField* field : {&residual_, &direction_, &product_, &preconditioned_}) {
      sum += field->bytes();
    }
    return sum;
  }

  const BandFactor* band_factor() const override {
    return preconditioner_ ? preconditioner_->band_factor() : nullptr;
  }

  bool prepare_rows(const GroupSystem& system, RowRange rows, std::span<Vector3<Pack>> x) override {
    if (!preconditioner_) return true;
    return naming<LinearSolver>(preconditioner_->name(),
                                [&] { return preconditioner_->prepare_rows(system, rows, x); });
  }

  bool prepare(const SystemMatrix& a) override {
    matrix_ = &a;
    if (!preconditioner_) return true;
    return naming(*preconditioner_, [&] { return preconditioner_->prepare(a); });
  }

  /// Where the matrix or the preconditioner turns out not to be positive definite, the last iterate
  /// is returned as not converged.
  SolveReport solve(const VertexField& b, VertexField& x) override {
    if (const BandFactor* factor = band_factor()) {
      return coupled_.solve(*factor, matrix_->couplings, b, x,
                            {parameters_.tolerance, parameters_.max_iterations});
    }
    begin(b, x);
    precondition();
    const double start = dot_residual();
    SolveReport report{.converged = start == 0, .residual = start == 0 ? 0.0 : 1.0};
    if (!(start > 0) || !std::isfinite(start)) return report;

    turn_direction(0);
    double squared_norm = start;
    while (report.iterations < parameters_.max_iterations) {
      const double alpha = squared_norm / multiply_direction();
      if (!(alpha > 0) || !std::isfinite(alpha)) break;
      ++report.iterations;
      go(alpha, x);
      precondition();
      const double next_squared_norm = dot_residual();
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
  /// x = 0, p = 0 and r = b.
  void begin(const VertexField& b, VertexField& x) {
    for_groups([&](int g) {
      const auto r = residual_.group(g), p = direction_.group(g), solution = x.group(g);
      const auto right = b.group(g);
      for (std::size_t i = 0; i < r.size(); ++i) {
        solution[i] = p[i] = {0, 0, 0};
        r[i] = right[i];
      }
    });
  }

  /// z = P^-1 r.
  void precondition() {
    if (!preconditioner_) return;
    naming(*preconditioner_, [&] { preconditioner_->apply(residual_, preconditioned_); });
  }
  const VertexField& preconditioned() const {
    return preconditioner_ ? preconditioned_ : residual_;
  }
  /// r^T z.
  double dot_residual() { return sum_.dot(residual_, preconditioned()); }

  /// p = z + beta p.
  void turn_direction(double beta) {
    for_groups([&](int g) {
      const auto p = direction_.group(g);
      const auto z = preconditioned().group(g);
      for (std::size_t i = 0; i < p.size(); ++i) p[i] = z[i] + Pack(beta) * p[i];
    });
  }

  /// q = A p; returns p^T q.
  double multiply_direction() {
    multiply(*matrix_, direction_, product_);
    return sum_.dot(direction_, product_);
  }

  /// x += alpha p, r -= alpha q.
  void go(double alpha, VertexField& x) {
    for_groups([&](int g) {
      const auto solution = x.group(g), r = residual_.group(g), p = direction_.group(g),
                 q = product_.group(g);
      for (std::size_t i = 0; i < r.size(); ++i) {
        solution[i] += Pack(alpha) * p[i];
        r[i] -= Pack(alpha) * q[i];
      }
    });
  }

  template <class Body>
  void for_groups(const Body& body) {
    parallel_for_each(residual_.groups().count(), body);
  }

  PcgParameters parameters_;
  std::unique_ptr<LinearSolver> preconditioner_;
  const SystemMatrix* matrix_ = nullptr;
  GroupSum sum_;
  VertexField residual_, preconditioned_, direction_, product_;
  CoupledGradients coupled_;  // where the preconditioner is a factor of the bands
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
