#include "core/rank_one_update.h"

#include <Eigen/Jacobi>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include "core/error.h"

namespace ringlet {
namespace {

/// What may be neglected of a matrix whose eigenvalues d have size 1.
constexpr double tolerance = 8 * std::numeric_limits<double>::epsilon();

void check(const Eigensystem& system, double rho, const Eigen::VectorXd& vector) {
  const Eigen::Index n = system.values.size();
  const Eigen::Index rows = system.vectors.rows(), columns = system.vectors.cols();
  if (n == 0 || rows != n || columns != n || vector.size() != n) {
    throw Error("rank-one update: sizes do not match: " + std::to_string(n) + " eigenvalues, " +
                std::to_string(rows) + " x " + std::to_string(columns) + " eigenvectors, " +
                std::to_string(vector.size()) + " numbers in the vector; expected n, n x n, n");
  }
  if (!system.values.allFinite() || !system.vectors.allFinite() || !vector.allFinite() ||
      !std::isfinite(rho)) {
    throw Error("rank-one update: the eigensystem, rho and the vector must be finite");
  }
}

Eigensystem sorted(const Eigensystem& system) {
  std::vector<int> order(system.values.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return system.values(a) < system.values(b); });
  return {system.values(order), system.vectors(Eigen::all, order)};
}

/// Rotates two eigenvectors such that z meets only the second, and says so; does nothing where
/// their eigenvalues differ by more than this can neglect.
bool merge(Eigensystem& system, Eigen::VectorXd& z, int first, int second) {
  const double length = std::hypot(z(first), z(second));
  const double c = z(second) / length, s = z(first) / length;
  const double gap = system.values(second) - system.values(first);
  if (gap * std::abs(c * s) > tolerance) return false;
  system.vectors.applyOnTheRight(first, second, Eigen::JacobiRotation<double>(c, s));
  system.values(first) += s * s * gap;
  system.values(second) -= s * s * gap;
  z(first) = 0;
  z(second) = length;
  return true;
}

/// The indices of the eigenpairs that change, their eigenvalues clearly apart.
std::vector<int> deflate(Eigensystem& system, Eigen::VectorXd& z, double rho) {
  std::vector<int> changing;
  for (int i = 0; i < z.size(); ++i) {
    if (rho * std::abs(z(i)) <= tolerance) continue;
    if (!changing.empty() && merge(system, z, changing.back(), i)) changing.pop_back();
    changing.push_back(i);
  }
  return changing;
}

/// The distance s > 0 from a pole to the root beside it of constant + sum weights/(offsets - s),
/// where the offsets are those of all poles, 0 for this one, and s <= start.
///
/// Newton's method on the function times s, which between the pole and the next is convex and
/// negative at 0: the iterates fall towards the root and need no safeguard until rounding stops
/// them. The step is written as a quotient, so that also a tiny s keeps all its digits.
double distance_to_root(double constant, const Eigen::ArrayXd& offsets,
                        const Eigen::ArrayXd& weights, double start) {
  double s = start;
  while (true) {
    const Eigen::ArrayXd inverse = (offsets - s).inverse();
    const double slope = constant + (weights * offsets * inverse.square()).sum();
    const double next = (weights * (s * inverse).square()).sum() / slope;
    if (!(next > 0 && next < s)) return s;
    s = next;
  }
}

/// The new eigenvalues of diag(d) + rho z z^T with d ascending, rho > 0, no z_i = 0.
struct Roots {
  Eigen::VectorXd values;
  Eigen::MatrixXd differences;  ///< d_i - values_j, to full relative precision

  Roots(const Eigen::ArrayXd& d, const Eigen::ArrayXd& z, double rho)
      : values(d.size()), differences(d.size(), d.size()) {
    for (int j = 0; j < d.size(); ++j) find(j, d, z.square(), rho);
  }

 private:
  /// Root j lies between d_j and d_(j + 1), and is found from the nearer of them.
  void find(int j, const Eigen::ArrayXd& d, const Eigen::ArrayXd& weights, double rho) {
    const Eigen::ArrayXd offsets = d - d(j);
    const bool last = j + 1 == d.size();
    const double start = last ? rho * weights.sum() : 0.5 * offsets(j + 1);
    if (last || 1 / rho + (weights / (offsets - start)).sum() >= 0) {
      const double s = distance_to_root(1 / rho, offsets, weights, start);
      values(j) = d(j) + s;
      differences.col(j) = offsets - s;
    } else {
      const Eigen::ArrayXd mirrored = d(j + 1) - d;
      const double s = distance_to_root(-1 / rho, mirrored, weights, start);
      values(j) = d(j + 1) - s;
      differences.col(j) = s - mirrored;
    }
  }
};

/// The z of which the roots are exact, but for a common factor (Gu & Eisenstat 1994):
/// z_i^2 ~ prod_j (values_j - d_i) / prod_(j != i) (d_j - d_i).
Eigen::VectorXd recompute_z(const Eigen::ArrayXd& d, const Eigen::VectorXd& z, const Roots& roots) {
  Eigen::VectorXd exact(z.size());
  for (int i = 0; i < z.size(); ++i) {
    double squared = -roots.differences(i, i);
    for (int j = 0; j < z.size(); ++j) {
      if (j != i) squared *= roots.differences(i, j) / (d(i) - d(j));
    }
    exact(i) = std::copysign(std::sqrt(squared), z(i));
  }
  return exact;
}

/// The system with eigenvalues of about size 1, rho > 0 and z = Q^T v of length 1.
void update(Eigensystem& system, double rho, Eigen::VectorXd z) {
  const std::vector<int> changing = deflate(system, z, rho);
  if (changing.empty()) return;
  const Eigen::VectorXd d = system.values(changing);
  z = z(changing).eval();
  const Roots roots(d, z, rho);
  Eigen::MatrixXd rotation =
      recompute_z(d, z, roots).asDiagonal() * roots.differences.cwiseInverse();
  rotation.colwise().normalize();
  system.values(changing) = roots.values;
  system.vectors(Eigen::all, changing) = (system.vectors(Eigen::all, changing) * rotation).eval();
}

}  // namespace

Eigensystem rank_one_update(const Eigensystem& system, double rho, const Eigen::VectorXd& vector) {
  check(system, rho, vector);
  const double length = vector.stableNorm();
  const double strength = std::abs(rho) * length * length;
  if (!std::isfinite(strength)) throw Error("rank-one update: rho times |vector|^2 overflows");
  if (strength == 0) return sorted(system);

  // Scaled, such that squares neither overflow nor underflow, and negated where rho is negative.
  const double sign = std::copysign(1.0, rho);
  const double size = std::max(system.values.cwiseAbs().maxCoeff(), 1e-40 * strength);
  Eigensystem updated = sorted({sign * system.values / size, system.vectors});
  update(updated, strength / size, updated.vectors.transpose() * (vector / length));
  updated.values *= sign * size;
  return sorted(updated);
}

}  // namespace ringlet
