#pragma once

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
/// Solves with it at once, x = A^-1 x. Returns false, and leaves factor and x unusable, if a pivot
/// of any lane is not positive and finite.
bool factor_and_solve(GroupBands bands, std::span<Vector3<Pack>> x);

/// x = (L L^T)^-1 x. Where x is zero before row `first`, it is left undefined there.
void solve_bands(GroupBands factor, std::span<Vector3<Pack>> x, int first = 0);

}  // namespace ringlet
