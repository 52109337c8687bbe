#pragma once

#include <array>
#include <span>

#include "core/strand_bands.h"
#include "solvers/block_cholesky.h"

namespace ringlet {

/// Factors the bands of a group in place, block row by block row, strands side by side in lanes:
///
///     S(i, j) = A(i, j) - sum over m < j of L(i, m) L(j, m)^T
///     L(i, j) = S(i, j) L(j, j)^-T for j < i,   L(i, i) L(i, i)^T = S(i, i)
///
/// (Golub, Van Loan: Matrix Computations, section 4.3.5, with 3x3 blocks and bandwidth 3). L(i, j)
/// takes the place of A(i, j), and the inverse of L(i, i), an InverseTriangle, that of A(i, i).
/// So for some rows, the factors of those before being known; solves at once L y = x, y in the
/// place of x. Returns false, and leaves factor and x unusable, if a pivot of any lane is not
/// positive and finite.
bool factor_rows(GroupBands bands, RowRange rows, std::span<Vector3<Pack>> x);
/// x = L^-T x, when all rows are factored: x has become A^-1 of what it was at first.
void substitute_back(GroupBands factor, std::span<Vector3<Pack>> x);

/// Half as wide as a pack, with a number a lane all the same.
using SinglePack =
    std::experimental::simd<float, std::experimental::simd_abi::deduce_t<float, lane_count>>;

/// A block row of a factor as it is kept, in double or, rounded, in single precision: the
/// InverseTriangle of its diagonal, and left[k - 1] = L(i, i - k).
template <class Stored>
struct FactorRow {
  std::array<Stored, 6> inverse_diagonal;
  std::array<Matrix3<Stored>, band_blocks - 1> left;
};

/// Copies the factor that factor_rows() made.
template <class Stored>
void keep_factor(GroupBands factor, std::span<FactorRow<Stored>> kept);

/// x = (L L^T)^-1 x. Where x is zero before row `first`, it is left undefined there.
template <class Stored>
void solve_bands(std::span<const FactorRow<Stored>> factor, std::span<Vector3<Pack>> x, int first);

extern template void keep_factor<Pack>(GroupBands, std::span<FactorRow<Pack>>);
extern template void keep_factor<SinglePack>(GroupBands, std::span<FactorRow<SinglePack>>);
extern template void solve_bands<Pack>(std::span<const FactorRow<Pack>>, std::span<Vector3<Pack>>,
                                       int);
extern template void solve_bands<SinglePack>(std::span<const FactorRow<SinglePack>>,
                                             std::span<Vector3<Pack>>, int);

}  // namespace ringlet
