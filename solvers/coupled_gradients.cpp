#include "solvers/coupled_gradients.h"

#include <algorithm>
#include <cmath>

namespace ringlet {

void CoupledGradients::bind(const StrandGroups& groups) {
  groups_ = &groups;
  sum_ = GroupSum(groups);
}

/// body(group, number of its first coupled vertex, count of them), groups in parallel.
template <class Body>
void CoupledGradients::for_coupled(const Body& body) const {
  parallel_for_each(groups_->count(), [&](int g) {
    const int count = static_cast<int>(couplings_->coupled(g).size());
    if (count > 0) body(g, couplings_->first_coupled(g), count);
  });
}

template <class Body>
double CoupledGradients::sum_coupled(const Body& body) {
  return sum_([&](int g) {
    const int count = static_cast<int>(couplings_->coupled(g).size());
    return count > 0 ? body(g, couplings_->first_coupled(g), count) : 0.0;
  });
}

SolveReport CoupledGradients::solve(const BandFactor& factor, const Couplings& couplings,
                                    const VertexField& b, VertexField& x, const Stop& stop) {
  factor_ = &factor;
  couplings_ = &couplings;
  const double start = squared_norm(b, x);
  SolveReport report{.converged = start == 0};
  if (!(start > 0) || !std::isfinite(start)) return report;

  double squared_norm = begin(x), last_squared_norm = squared_norm;
  while (std::isfinite(squared_norm) && squared_norm >= 0) {
    report.residual = std::sqrt(squared_norm / start);
    report.converged = report.residual <= stop.tolerance;
    if (report.converged || report.iterations == stop.max_iterations) break;
    if (report.iterations > 0) turn_direction(squared_norm / last_squared_norm);
    const double alpha = squared_norm / multiply_direction();
    if (!(alpha > 0) || !std::isfinite(alpha)) break;
    ++report.iterations;
    last_squared_norm = squared_norm;
    squared_norm = go(alpha);
  }
  if (report.iterations > 0) finish(x);
  return report;
}

/// b^T B^-1 b of the coupled groups.
double CoupledGradients::squared_norm(const VertexField& b, const VertexField& x) {
  return sum_coupled([&](int g, int, int) {
    const auto b_rows = b.group(g), x_rows = x.group(g);
    Pack sum = 0;
    for (std::size_t i = 0; i < b_rows.size(); ++i) sum += dot(b_rows[i], x_rows[i]);
    return sum_lanes(sum);
  });
}

/// r = -C x, z = B^-1 r, p = z and B p = r; returns r^T z.
double CoupledGradients::begin(const VertexField& x) {
  for (Vectors* vectors : {&residual_, &preconditioned_, &direction_, &band_product_,
                           &coupling_product_, &right_side_}) {
    vectors->resize(couplings_->coupled_count());
  }
  slots_.resize(couplings_->coupled_count());
  for_coupled([&](int g, int first, int n) {
    const auto vertices = couplings_->coupled(g);
    for (int i = 0; i < n; ++i) {
      preconditioned_[first + i] = from_eigen(x.get(vertices[i]));
      const LaneSlot slot = groups_->slot(vertices[i]);
      slots_[first + i] = {slot.row - (*groups_)[g].first_row, slot.lane};
    }
  });
  for_coupled([&](int g, int first, int n) {
    couplings_->multiply(g, preconditioned_, std::span(residual_).subspan(first, n));
  });
  return sum_coupled([&](int g, int first, int n) {
    for (int i = first; i < first + n; ++i) {
      residual_[i] = band_product_[i] = -residual_[i];
      right_side_[i] = {0, 0, 0};
    }
    const double product = precondition(g);
    std::copy_n(&preconditioned_[first], n, &direction_[first]);
    return product;
  });
}

/// z = B^-1 r in a group; returns its part of r^T z.
double CoupledGradients::precondition(int group) {
  const std::span<Vector3<Pack>> rows = rows_with(residual_, group);
  factor_->solve_group(group, couplings_->first_coupled_row(group), rows);
  double product = 0;
  const int first = couplings_->first_coupled(group),
            count = static_cast<int>(couplings_->coupled(group).size());
  for (int i = first; i < first + count; ++i) {
    const auto [row, lane] = slots_[i];
    const Vector3<Pack>& z = rows[row];
    preconditioned_[i] = {z.x[lane], z.y[lane], z.z[lane]};
    product += dot(residual_[i], preconditioned_[i]);
  }
  return product;
}

/// p = z + beta p, and so B p = r + beta B p.
void CoupledGradients::turn_direction(double beta) {
  for_coupled([&](int, int first, int n) {
    for (int i = first; i < first + n; ++i) {
      direction_[i] = preconditioned_[i] + beta * direction_[i];
      band_product_[i] = residual_[i] + beta * band_product_[i];
    }
  });
}

/// Returns p^T A p.
double CoupledGradients::multiply_direction() {
  return sum_coupled([&](int g, int first, int n) {
    couplings_->multiply(g, direction_, std::span(coupling_product_).subspan(first, n));
    double product = 0;
    for (int i = first; i < first + n; ++i) {
      product += dot(direction_[i], band_product_[i] + coupling_product_[i]);
    }
    return product;
  });
}

/// r -= alpha A p and z = B^-1 r, and the iterate moves by alpha p; returns r^T z.
double CoupledGradients::go(double alpha) {
  return sum_coupled([&](int g, int first, int n) {
    for (int i = first; i < first + n; ++i) {
      residual_[i] -= alpha * (band_product_[i] + coupling_product_[i]);
      right_side_[i] += alpha * band_product_[i];
    }
    return precondition(g);
  });
}

/// x += B^-1 (sum of alpha B p).
void CoupledGradients::finish(VertexField& x) {
  for_coupled([&](int g, int, int) {
    const std::span<Vector3<Pack>> rows = rows_with(right_side_, g);
    factor_->solve_group(g, 0, rows);
    const auto x_rows = x.group(g);
    for (std::size_t i = 0; i < rows.size(); ++i) x_rows[i] += rows[i];
  });
}

/// The rows of a group, zero but for what the coupled vertices have; in the calling thread alone,
/// until the next call.
std::span<Vector3<Pack>> CoupledGradients::rows_with(const Vectors& values, int group) {
  std::vector<Vector3<Pack>>& rows = temporary_.local();
  rows.assign((*groups_)[group].vertices, {0, 0, 0});
  const int first = couplings_->first_coupled(group),
            count = static_cast<int>(couplings_->coupled(group).size());
  for (int i = first; i < first + count; ++i) {
    const auto [row, lane] = slots_[i];
    rows[row].x[lane] = values[i].x;
    rows[row].y[lane] = values[i].y;
    rows[row].z[lane] = values[i].z;
  }
  return rows;
}

std::size_t CoupledGradients::bytes() const {
  std::size_t sum = 0;
  for (const Vectors* vectors : {&residual_, &preconditioned_, &direction_, &band_product_,
                                 &coupling_product_, &right_side_}) {
    sum += bytes_of(*vectors);
  }
  for (const auto& rows : temporary_) sum += bytes_of(rows);
  sum += bytes_of(slots_);
  return sum;
}

}  // namespace ringlet
