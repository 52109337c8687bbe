#pragma once

#include <array>
#include <span>

#include "core/strand_bands.h"
#include "solvers/block_cholesky.h"

namespace ringlet {

/// A row of blocks of the Cholesky factor L of the eight strands of a group, A = L L^T.
struct BandFactorRow {
  std::array<Matrix3<Pack>, band_blocks - 1> left;  ///< left[k - 1] is L(i, i - k)
  InverseTriangle inverse_diagonal;                 ///< L(i, i)^-1
};

/// Factors the bands of a group, block row by block row, eight strands in lanes:
///
///     S(i, j) = A(i, j) - sum over m < j of L(i, m) L(j, m)^T
///     L(i, j) = S(i, j) L(j, j)^-T for j < i,   L(i, i) L(i, i)^T = S(i, i)
///
/// (Golub, Van Loan: Matrix Computations, section 4.3.5, with 3x3 blocks and bandwidth 3). Returns
/// false, and leaves the factor unusable, if a pivot of any lane is not positive and finite.
bool factor_bands(const StrandBands& bands, int group, std::span<BandFactorRow> factor);

/// x = (L L^T)^-1 b. b and x may be the same.
void solve_bands(std::span<const BandFactorRow> factor, std::span<const Vector3<Pack>> b,
                 std::span<Vector3<Pack>> x);

}  // namespace ringlet
