// The conjugate residual method with the diagonal 3x3 blocks D of A as preconditioner (Saad:
// Iterative Methods for Sparse Linear Systems, sections 6.8 and 9.2). Each iterate has the smallest
// residual norm sqrt(r^T D^-1 r) that its Krylov space allows. With z = D^-1 r and q = A p:
//
//     alpha = z^T A z / q^T D^-1 q      x += alpha p,  z -= alpha D^-1 q
//     beta = z'^T A z' / z^T A z        p = z' + beta p,  q = A z' + beta q

#include <cmath>

#include "core/linear_solver.h"
#include "core/plugin.h"
#include "solvers/block_cholesky.h"
#include "solvers/group_sum.h"

namespace {

using namespace ringlet;

struct ConjugateResidualParameters {
  double tolerance = 1e-6;
  int max_iterations = 1000;

  static Schema<ConjugateResidualParameters> schema() {
    return Schema<ConjugateResidualParameters>()
        .key("tolerance", &ConjugateResidualParameters::tolerance, "", positive(),
             "stop when sqrt(r^T D^-1 r) has fallen to this part of its start")
        .key("max_iterations", &ConjugateResidualParameters::max_iterations, "", at_least(1),
             "cap; the step report tells when it is hit");
  }
};

class ConjugateResidual final : public LinearSolver {
 public:
  explicit ConjugateResidual(const ConjugateResidualParameters& parameters)
      : parameters_(parameters) {}

  void bind(const StrandGroups& groups) override {
    groups_ = &groups;
    sum_ = GroupSum(groups);
    inverse_.resize(groups.rows());
    residual_ = z_ = image_of_z_ = direction_ = image_ = VertexField(groups);
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

  /// Where the matrix turns out not to be positive definite, the last iterate is returned as not
  /// converged.
  SolveReport solve(const VertexField& b, VertexField& x) override {
    x.set_zero();
    residual_ = b;
    direction_.set_zero();
    image_.set_zero();
    const double start = precondition();
    SolveReport report{.converged = start == 0, .residual = start == 0 ? 0.0 : 1.0};
    if (!(start > 0) || !std::isfinite(start)) return report;

    double last_curvature = 0;
    while (report.iterations < parameters_.max_iterations) {
      multiply(*matrix_, z_, image_of_z_);
      const double curvature = sum_.dot(z_, image_of_z_);
      if (!(curvature > 0) || !std::isfinite(curvature)) break;
      turn_direction(report.iterations == 0 ? 0 : curvature / last_curvature);
      last_curvature = curvature;
      const double alpha = curvature / squared_norm_of_image();
      if (!std::isfinite(alpha)) break;
      add_scaled(x, alpha, direction_);
      add_scaled(residual_, -alpha, image_);
      const double squared_norm = precondition();
      if (!std::isfinite(squared_norm)) break;
      ++report.iterations;
      report.residual = std::sqrt(squared_norm / start);
      report.converged = report.residual <= parameters_.tolerance;
      if (report.converged) break;
    }
    return report;
  }

 private:
  /// z = D^-1 r; returns r^T z.
  double precondition() {
    return sum_([&](int g) {
      const auto r = residual_.group(g), z = z_.group(g);
      const InverseTriangle* inverse = &inverse_[(*groups_)[g].first_row];
      Pack sum = 0;
      for (std::size_t i = 0; i < r.size(); ++i) {
        z[i] = transpose_multiply(inverse[i], inverse[i] * r[i]);
        sum += dot(r[i], z[i]);
      }
      return sum_lanes(sum);
    });
  }

  /// p = z + beta p and q = A z + beta q.
  void turn_direction(double beta) {
    parallel_for_each(groups_->count(), [&](int g) {
      const auto p = direction_.group(g), q = image_.group(g), z = z_.group(g),
                 az = image_of_z_.group(g);
      for (std::size_t i = 0; i < p.size(); ++i) {
        p[i] = z[i] + Pack(beta) * p[i];
        q[i] = az[i] + Pack(beta) * q[i];
      }
    });
  }

  /// q^T D^-1 q.
  double squared_norm_of_image() {
    return sum_([&](int g) {
      const auto q = image_.group(g);
      const InverseTriangle* inverse = &inverse_[(*groups_)[g].first_row];
      Pack sum = 0;
      for (std::size_t i = 0; i < q.size(); ++i) sum += squared_norm(inverse[i] * q[i]);
      return sum_lanes(sum);
    });
  }

  ConjugateResidualParameters parameters_;
  const StrandGroups* groups_ = nullptr;
  const SystemMatrix* matrix_ = nullptr;
  GroupSum sum_;
  std::vector<InverseTriangle> inverse_;  // of the Cholesky factors of D
  VertexField residual_, z_, image_of_z_, direction_, image_;
};

void register_conjugate_residual(Registry& registry) {
  registry.of<LinearSolver>().add<ConjugateResidualParameters>(
      "conjugate_residual",
      {"the smallest residual at every iteration", "min (b - A x)^T D^-1 (b - A x)",
       "Saad: Iterative Methods for Sparse Linear Systems, section 6.8"},
      [](const ConjugateResidualParameters& parameters) {
        return std::make_unique<ConjugateResidual>(parameters);
      });
}

}  // namespace

RINGLET_PLUGIN(register_conjugate_residual);
