#pragma once

#include <span>
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
  Vector3<Pack> take_row(int i, Matrix3<Pack>* hessian_row);
  /// Takes all rows, and adds them.
  void add_to(const GroupOutputs& outputs);

  std::size_t bytes() const { return bytes_of(gradient_) + bytes_of(blocks_); }

 private:
  void write_hessian_row(int i, Matrix3<Pack>* row) const;
  void clear(int entry);

  // Entry 0 stands for the edge before the root, which does not exist and stays zero, as does the
  // one behind the tip.
  int vertices_ = 0;
  int taken_ = 0;
  std::vector<Vector3<Pack>> gradient_;
  std::vector<Matrix3<Pack>> blocks_;
};

}  // namespace ringlet
