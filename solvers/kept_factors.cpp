#include "solvers/kept_factors.h"

namespace ringlet {
namespace {

/// What rounding may do, a part of the tolerance: the change is measured along one vector a strand,
/// and is larger along others.
constexpr double part_of_tolerance = 1e-2;
/// Rounding to single precision changes more than this in any case.
constexpr double least_change = 1e-8;

}  // namespace

void KeptFactors::bind(const StrandGroups& groups, double tolerance) {
  groups_ = &groups;
  largest_change_ = part_of_tolerance * tolerance;
  exact_.resize(groups.count());
}

void KeptFactors::keep(int group, GroupBands factor, std::span<const Vector3<Pack>> b,
                       std::span<const Vector3<Pack>> x) {
  Rows<Pack>& exact = exact_[group];
  exact.clear();
  if (largest_change_ > least_change) {
    const std::span<FactorRow<SinglePack>> rows = rounded(group);
    keep_factor(factor, rows);
    if (is_close(rows, b, x)) return;
  }
  exact.resize(factor.rows());
  keep_factor(factor, std::span(exact));
}

std::span<FactorRow<SinglePack>> KeptFactors::rounded(int group) {
  std::call_once(has_rounded_, [&] { rounded_.resize(groups_->rows()); });
  const StrandGroup& rows = (*groups_)[group];
  return std::span(rounded_).subspan(rows.first_row, rows.vertices);
}

/// |x^T (B - L L^T) x| / x^T B x is small, where B x = b and L is the factor. To first order in the
/// rounding it is |b^T (y - x)| / b^T x, y being the solution of L L^T y = b.
bool KeptFactors::is_close(std::span<const FactorRow<SinglePack>> factor,
                           std::span<const Vector3<Pack>> b, std::span<const Vector3<Pack>> x) {
  std::vector<Vector3<Pack>>& y = temporary_.local();
  y.assign(b.begin(), b.end());
  solve_bands(factor, std::span(y), 0);
  Pack change = 0, whole = 0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    change += dot(b[i], y[i] - x[i]);
    whole += dot(b[i], x[i]);
  }
  return sum_lanes(abs(change)) <= largest_change_ * sum_lanes(whole);
}

void KeptFactors::solve(int group, int first, std::span<Vector3<Pack>> x) const {
  if (!exact_[group].empty()) {
    solve_bands(std::span<const FactorRow<Pack>>(exact_[group]), x, first);
  } else {
    const StrandGroup& rows = (*groups_)[group];
    solve_bands(std::span(rounded_).subspan(rows.first_row, rows.vertices), x, first);
  }
}

std::size_t KeptFactors::bytes() const {
  std::size_t sum = bytes_of(rounded_);
  for (const Rows<Pack>& rows : exact_) sum += bytes_of(rows);
  for (const auto& rows : temporary_) sum += bytes_of(rows);
  return sum;
}

}  // namespace ringlet
