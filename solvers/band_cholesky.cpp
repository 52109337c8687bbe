#include "solvers/band_cholesky.h"

#include <type_traits>

#include "solvers/unrolled.h"

namespace ringlet {
namespace {

/// Calls body with the number of blocks that row i has left of the diagonal, as a constant, so that
/// the loops over the band unroll.
template <class Body>
inline void with_left_blocks(int i, const Body& body) {
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
  unrolled<3>([&](auto r) {
    unrolled<3>([&](auto m) { unrolled<3>([&](auto c) { s(r, c) -= a(r, m) * b(c, m); }); });
  });
}

/// s -= a a^T, lower triangles only.
inline void subtract_square(std::array<Pack, 6>& s, const Matrix3<Pack>& a) {
  unrolled<3>([&](auto m) {
    s[0] -= a(0, m) * a(0, m);
    s[1] -= a(1, m) * a(0, m);
    s[2] -= a(1, m) * a(1, m);
    s[3] -= a(2, m) * a(0, m);
    s[4] -= a(2, m) * a(1, m);
    s[5] -= a(2, m) * a(2, m);
  });
}

/// A row of blocks, of A or of the factor in its place: row[k] stands at (i, i - k).
using Row = Matrix3<Pack>*;
using ConstRow = const Matrix3<Pack>*;

inline InverseTriangle inverse_diagonal(ConstRow row) {
  const auto& m = row[0].m;
  return {{m[0], m[1], m[2], m[3], m[4], m[5]}};
}
inline const Matrix3<Pack>& left_block(ConstRow row, int k) { return row[k]; }
inline ConstRow above(ConstRow row, int k) { return row - k * band_blocks; }

inline Pack widened(const Pack& numbers) { return numbers; }
inline Pack widened(const SinglePack& numbers) {
  return std::experimental::static_simd_cast<Pack>(numbers);
}

/// The same of a row that is kept.
template <class Stored>
inline InverseTriangle inverse_diagonal(const FactorRow<Stored>& row) {
  InverseTriangle inverse;
  for (int n = 0; n < 6; ++n) inverse.t[n] = widened(row.inverse_diagonal[n]);
  return inverse;
}
template <class Stored>
inline Matrix3<Pack> left_block(const FactorRow<Stored>& row, int k) {
  Matrix3<Pack> block;
  for (int n = 0; n < 9; ++n) block.m[n] = widened(row.left[k - 1].m[n]);
  return block;
}

/// One row of the factor, of which the rows before are known, in the place of that row of A.
template <int left>
inline void factor_row(Row row, Mask& bad) {
  unrolled<left>([&](auto n) {
    constexpr int k = left - n;
    Matrix3<Pack> s = row[k];
    unrolled<n>([&](auto m) { subtract_product(s, row[k + 1 + m], above(row, k)[1 + m]); });
    row[k] = times_transposed(s, inverse_diagonal(above(row, k)));
  });
  std::array<Pack, 6> s = lower_triangle(row[0]);
  unrolled<left>([&](auto n) { subtract_square(s, row[left - n]); });
  const InverseTriangle inverse = inverse_cholesky(s, bad);
  for (int n = 0; n < 6; ++n) row[0].m[n] = inverse.t[n];
}

/// Forward substitution: x points to a row of the solution, which holds the right-hand side.
template <int left, class AnyRow>
[[gnu::always_inline]] inline void solve_row(const AnyRow& row, Vector3<Pack>* x) {
  Vector3<Pack> sum = *x;
  for (int k = left; k >= 1; --k) sum -= left_block(row, k) * x[-k];
  *x = inverse_diagonal(row) * sum;
}

/// Backward substitution: solves a row, and takes its part off the rows above it.
template <int left, class AnyRow>
[[gnu::always_inline]] inline void solve_transposed_row(const AnyRow& row, Vector3<Pack>* x) {
  const Vector3<Pack> solved = *x = transpose_multiply(inverse_diagonal(row), *x);
  for (int k = 1; k <= left; ++k) x[-k] -= transpose_multiply(left_block(row, k), solved);
}

// The substitution waits for its own last result and so reads too slowly to keep the memory busy:
// prefetching takes a third off its time.
template <class Stored>
inline void prefetch(const FactorRow<Stored>& row) {
  constexpr std::size_t cache_line = 64;
  const char* bytes = reinterpret_cast<const char*>(&row);
  for (std::size_t n = 0; n < sizeof(row); n += cache_line) __builtin_prefetch(bytes + n, 0, 2);
}
constexpr int prefetch_rows = 16;

}  // namespace

// The forward substitution comes for free: a row of the factor waits for the one before it.
[[gnu::flatten]] bool factor_rows(GroupBands bands, RowRange rows, std::span<Vector3<Pack>> x) {
  Mask bad(false);
  for (int i = rows.first; i < rows.end; ++i) {
    with_left_blocks(i, [&](auto left) {
      factor_row<left>(&bands.block(i, 0), bad);
      solve_row<left>(ConstRow(&bands.block(i, 0)), &x[i]);
    });
  }
  return !any(bad);
}

[[gnu::flatten]] void substitute_back(GroupBands factor, std::span<Vector3<Pack>> x) {
  for (int i = factor.rows(); i-- > 0;) {
    with_left_blocks(
        i, [&](auto left) { solve_transposed_row<left>(ConstRow(&factor.block(i, 0)), &x[i]); });
  }
}

template <class Stored>
void keep_factor(GroupBands factor, std::span<FactorRow<Stored>> kept) {
  const auto stored = [](const Pack& numbers) {
    return std::experimental::static_simd_cast<Stored>(numbers);
  };
  for (int i = 0; i < factor.rows(); ++i) {
    for (int n = 0; n < 6; ++n) kept[i].inverse_diagonal[n] = stored(factor.block(i, 0).m[n]);
    for (int k = 1; k < band_blocks; ++k) {
      for (int n = 0; n < 9; ++n) kept[i].left[k - 1].m[n] = stored(factor.block(i, k).m[n]);
    }
  }
}

template <class Stored>
[[gnu::flatten]] void solve_bands(std::span<const FactorRow<Stored>> factor,
                                  std::span<Vector3<Pack>> x, int first) {
  const int rows = static_cast<int>(factor.size());
  for (int i = first; i < rows; ++i) {
    if (i + prefetch_rows < rows) prefetch(factor[i + prefetch_rows]);
    with_left_blocks(i, [&](auto left) { solve_row<left>(factor[i], &x[i]); });
  }
  for (int i = rows; i-- > first;) {
    with_left_blocks(i, [&](auto left) { solve_transposed_row<left>(factor[i], &x[i]); });
  }
}

template void keep_factor<Pack>(GroupBands, std::span<FactorRow<Pack>>);
template void keep_factor<SinglePack>(GroupBands, std::span<FactorRow<SinglePack>>);
template void solve_bands<Pack>(std::span<const FactorRow<Pack>>, std::span<Vector3<Pack>>, int);
template void solve_bands<SinglePack>(std::span<const FactorRow<SinglePack>>,
                                      std::span<Vector3<Pack>>, int);

}  // namespace ringlet
