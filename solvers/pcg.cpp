// Conjugate gradients with a preconditioner P (Hestenes, Stiefel 1952; Saad: Iterative Methods for
// Sparse Linear Systems, algorithm 9.1). Stops in the norm sqrt(r^T P^-1 r): in ||r|| the stiff
// stretching forces can satisfy a tolerance before the contacts feel anything.

#include <algorithm>
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
    solved_.assign(groups.count(), false);
    residual_ = direction_ = product_ = VertexField(groups);
    if (preconditioner_) {
      preconditioned_ = VertexField(groups);
      preconditioner_->bind(groups);
    }
    if (!keeps_bands()) band_product_ = VertexField(groups);
  }

  bool keeps_bands() const override { return !preconditioner_ || preconditioner_->keeps_bands(); }

  bool prepare_group(const GroupSystem& system, std::span<Vector3<Pack>> x) override {
    solved_[system.group] = preconditioner_ && preconditioner_->prepare_group(system, x);
    return solved_[system.group];
  }

  bool prepare(const SystemMatrix& a) override {
    matrix_ = &a;
    return !preconditioner_ || preconditioner_->prepare(a);
  }

  /// Where the matrix or the preconditioner turns out not to be positive definite, the last iterate
  /// is returned as not converged.
  SolveReport solve(const VertexField& b, VertexField& x) override {
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
  template <class Body>
  void for_unsolved(const Body& body) {
    parallel_for_each(static_cast<int>(solved_.size()), [&](int g) {
      if (!solved_[g]) body(g);
    });
  }

  /// x = 0 and r = b where the solution is not known yet; elsewhere nothing remains to be done, and
  /// no coupling leads there.
  void begin(const VertexField& b, VertexField& x) {
    parallel_for_each(static_cast<int>(solved_.size()), [&](int g) {
      const auto r = residual_.group(g), p = direction_.group(g), solution = x.group(g);
      const auto right = b.group(g);
      for (std::size_t i = 0; i < r.size(); ++i) {
        p[i] = {0, 0, 0};
        r[i] = solved_[g] ? p[i] : right[i];
        if (!solved_[g]) solution[i] = p[i];
      }
    });
  }

  /// z = P^-1 r.
  void precondition() {
    if (preconditioner_) preconditioner_->apply(residual_, preconditioned_);
  }
  const VertexField& preconditioned() const {
    return preconditioner_ ? preconditioned_ : residual_;
  }
  /// r^T z.
  double dot_residual() {
    return sum_([&](int g) {
      return solved_[g] ? 0.0 : dot(residual_.group(g), preconditioned().group(g));
    });
  }

  /// p = z + beta p; where P is A without its couplings, P p comes from the same recurrence, since
  /// P z = r.
  void turn_direction(double beta) {
    for_unsolved([&](int g) {
      const auto p = direction_.group(g);
      const auto z = preconditioned().group(g);
      for (std::size_t i = 0; i < p.size(); ++i) p[i] = z[i] + Pack(beta) * p[i];
      if (keeps_bands()) return;
      const auto u = band_product_.group(g);
      const auto r = residual_.group(g);
      for (std::size_t i = 0; i < p.size(); ++i) {
        u[i] = beta == 0 ? r[i] : r[i] + Pack(beta) * u[i];
      }
    });
  }

  /// q = A p; returns p^T q.
  double multiply_direction() {
    return sum_([&](int g) {
      if (solved_[g]) return 0.0;
      if (keeps_bands()) {
        multiply_group(*matrix_, g, direction_, product_);
      } else {
        const auto u = band_product_.group(g);
        std::copy(u.begin(), u.end(), product_.group(g).begin());
        matrix_->couplings.add_product(g, direction_, product_);
      }
      return dot(direction_.group(g), product_.group(g));
    });
  }

  /// x += alpha p, r -= alpha q.
  void go(double alpha, VertexField& x) {
    for_unsolved([&](int g) {
      const auto solution = x.group(g), r = residual_.group(g), p = direction_.group(g),
                 q = product_.group(g);
      for (std::size_t i = 0; i < r.size(); ++i) {
        solution[i] += Pack(alpha) * p[i];
        r[i] -= Pack(alpha) * q[i];
      }
    });
  }

  static double dot(std::span<const Vector3<Pack>> a, std::span<const Vector3<Pack>> b) {
    Pack sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += ringlet::dot(a[i], b[i]);
    return sum_lanes(sum);
  }

  PcgParameters parameters_;
  std::unique_ptr<LinearSolver> preconditioner_;
  const SystemMatrix* matrix_ = nullptr;
  GroupSum sum_;
  std::vector<char> solved_;  // groups of which the preconditioner has solved the system itself
  VertexField residual_, preconditioned_, direction_, product_, band_product_;
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
