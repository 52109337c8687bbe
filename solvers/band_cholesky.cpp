#include "solvers/band_cholesky.h"

#include <type_traits>

namespace ringlet {
namespace {

/// Calls body with the number of blocks that row i has left of the diagonal, as a constant, so that
/// the loops over the band unroll.
template <class Body>
inline void with_left_blocks(std::size_t i, const Body& body) {
  if (i >= 3) {
    body(std::integral_constant<int, 3>());
  } else if (i == 2) {
    body(std::integral_constant<int, 2>());
  } else if (i == 1) {
    body(std::integral_constant<int, 1>());
  } else {
    body(std::integral_constant<int, 0>());
  }
}

/// s -= a b^T.
inline void subtract_product(Matrix3<Pack>& s, const Matrix3<Pack>& a, const Matrix3<Pack>& b) {
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) {
      for (int m = 0; m < 3; ++m) s(r, c) -= a(r, m) * b(c, m);
    }
  }
}

/// s -= a a^T, lower triangles only.
inline void subtract_square(std::array<Pack, 6>& s, const Matrix3<Pack>& a) {
  for (int m = 0; m < 3; ++m) {
    s[0] -= a(0, m) * a(0, m);
    s[1] -= a(1, m) * a(0, m);
    s[2] -= a(1, m) * a(1, m);
    s[3] -= a(2, m) * a(0, m);
    s[4] -= a(2, m) * a(1, m);
    s[5] -= a(2, m) * a(2, m);
  }
}

/// One row of the factor, of which the rows before are known; a points to that row of A.
template <int left>
inline void factor_row(const Matrix3<Pack>* a, BandFactorRow* row, Mask& bad) {
  for (int k = left; k >= 1; --k) {
    Matrix3<Pack> s = a[k];
    for (int m = k + 1; m <= left; ++m) {
      subtract_product(s, row->left[m - 1], (row - k)->left[m - k - 1]);
    }
    row->left[k - 1] = times_transposed(s, (row - k)->inverse_diagonal);
  }
  std::array<Pack, 6> s = lower_triangle(a[0]);
  for (int k = left; k >= 1; --k) subtract_square(s, row->left[k - 1]);
  row->inverse_diagonal = inverse_cholesky(s, bad);
}

/// Forward substitution: x points to a row of the solution, which holds the right-hand side.
template <int left>
inline void solve_row(const BandFactorRow& row, Vector3<Pack>* x) {
  Vector3<Pack> sum = *x;
  for (int k = left; k >= 1; --k) sum -= row.left[k - 1] * x[-k];
  *x = row.inverse_diagonal * sum;
}

/// Backward substitution: solves a row, and takes its part off the rows above it.
template <int left>
inline void solve_transposed_row(const BandFactorRow& row, Vector3<Pack>* x) {
  const Vector3<Pack> solved = *x = transpose_multiply(row.inverse_diagonal, *x);
  for (int k = 1; k <= left; ++k) x[-k] -= transpose_multiply(row.left[k - 1], solved);
}

// The substitution waits for its own last result and so reads too slowly to keep the memory busy:
// prefetching takes a quarter off its time.
inline void prefetch(const BandFactorRow& row) {
  constexpr std::size_t cache_line = 64;
  const char* bytes = reinterpret_cast<const char*>(&row);
  for (std::size_t n = 0; n < sizeof(row); n += cache_line) __builtin_prefetch(bytes + n);
}
constexpr std::size_t prefetch_rows = 4;

}  // namespace

bool factor_bands(const StrandBands& bands, int group, std::span<BandFactorRow> factor) {
  const int first_row = bands.groups()[group].first_row;
  Mask bad(false);
  for (std::size_t i = 0; i < factor.size(); ++i) {
    const Matrix3<Pack>* a = &bands.block(first_row + static_cast<int>(i), 0);
    with_left_blocks(i, [&](auto left) { factor_row<left>(a, &factor[i], bad); });
  }
  return !any(bad);
}

void solve_bands(std::span<const BandFactorRow> factor, std::span<const Vector3<Pack>> b,
                 std::span<Vector3<Pack>> x) {
  for (std::size_t i = 0; i < factor.size(); ++i) {
    if (i + prefetch_rows < factor.size()) prefetch(factor[i + prefetch_rows]);
    x[i] = b[i];
    with_left_blocks(i, [&](auto left) { solve_row<left>(factor[i], &x[i]); });
  }
  for (std::size_t i = factor.size(); i-- > 0;) {
    with_left_blocks(i, [&](auto left) { solve_transposed_row<left>(factor[i], &x[i]); });
  }
}

}  // namespace ringlet
