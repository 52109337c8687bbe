#pragma once

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "core/bytes.h"
#include "core/strand_bands.h"

namespace ringlet {

/// No stencil reaches further along a strand than three edges.
inline constexpr int edge_band_blocks = band_blocks - 1;

/// The matrices over the edges of the strands of a group, a row an edge. Of the blocks on the
/// diagonal the lower triangle alone has a meaning.
using EdgeBands = BlockBands<edge_band_blocks>;

/// Where an energy adds its derivatives with respect to the edges of a group of strands; what is
/// empty is not wanted.
struct EdgeOutputs {
  std::span<Vector3<Pack>> gradient;
  EdgeBands hessian;
};

/// Gradient g and Hessian H of a function of the edges e_i = x_{i+1} - x_i of the strands of one
/// group, and what they are with respect to the vertices x = (x_0, x_1, ...): with e = D x,
///
///     D^T g  and  D^T H D
///
/// An elastic energy depends on the edges alone. Its derivatives are fewer numbers with respect to
/// them, and they are turned into those of the vertices once for all energies.
class EdgeDerivatives {
 public:
  /// Zero, for strands of so many vertices. Allocates only where more are asked for than before,
  /// and is fastest where all rows were taken.
  void begin(int vertices);
  EdgeOutputs outputs();

  // The rows are taken once each, from the root on. Behind them zero is left for what comes next,
  // while it is warm in cache.
  /// Row i of D^T g; writes row i of D^T H D, the band_blocks blocks of a row of GroupBands.
  [[gnu::always_inline]] Vector3<Pack> take_row(int i, Matrix3<Pack>* hessian_row) {
    const Vector3<Pack> gradient_row = gradient_[i] - gradient_[i + 1];
    Matrix3<Pack>* before = &blocks_[i * edge_band_blocks];
    // Loops over the entries would stay loops.
    [&]<int... entries>(std::integer_sequence<int, entries...>) {
      (write_entry<entries / 3, entries % 3>(before, hessian_row), ...);
    }
    (std::make_integer_sequence<int, 9>());
    clear(i);
    taken_ = i + 1;
    return gradient_row;
  }
  /// Takes all rows, and adds them.
  void add_to(const GroupOutputs& outputs);

  std::size_t bytes() const { return bytes_of(gradient_) + bytes_of(blocks_); }

 private:
  // With (i, k) for the block of H at edges i and i - k, row i of D^T H D has the blocks
  //
  //     (i-1, 0) + (i, 0) - (i, 1) - (i, 1)^T,  (i-1, 1) + (i, 1) - (i, 2) - (i-1, 0),
  //     (i-1, 2) + (i, 2) - (i-1, 1),           -(i-1, 2)
  template <int r, int c>
  [[gnu::always_inline]] static void write_entry(const Matrix3<Pack>* before, Matrix3<Pack>* row) {
    const Matrix3<Pack>* own = before + edge_band_blocks;
    const Pack diagonal = before[0](std::max(r, c), std::min(r, c));
    if constexpr (r >= c) {
      row[0](r, c) = row[0](c, r) = diagonal + own[0](r, c) - own[1](r, c) - own[1](c, r);
    }
    row[1](r, c) = before[1](r, c) + own[1](r, c) - own[2](r, c) - diagonal;
    row[2](r, c) = before[2](r, c) + own[2](r, c) - before[1](r, c);
    row[3](r, c) = -before[2](r, c);
  }
  [[gnu::always_inline]] void clear(int entry) {
    gradient_[entry] = {0, 0, 0};
    for (int k = 0; k < edge_band_blocks; ++k) {
      blocks_[entry * edge_band_blocks + k] = Matrix3<Pack>::zero();
    }
  }

  // Entry 0 stands for the edge before the root, which does not exist and stays zero, as does the
  // one behind the tip.
  int vertices_ = 0;
  int taken_ = 0;
  std::vector<Vector3<Pack>> gradient_;
  std::vector<Matrix3<Pack>> blocks_;
};

}  // namespace ringlet
