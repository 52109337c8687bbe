#include "core/edge_derivatives.h"

#include <algorithm>

namespace ringlet {

void EdgeDerivatives::begin(int vertices) {
  // Left behind by an exception, perhaps.
  for (int i = taken_; i <= vertices_ && !gradient_.empty(); ++i) clear(i);
  const std::size_t rows = vertices + 1;
  if (rows > gradient_.size()) {
    gradient_.resize(rows);
    blocks_.resize(rows * edge_band_blocks);
    for (int i = 0; i <= vertices; ++i) clear(i);
  }
  vertices_ = vertices;
  taken_ = 0;
}

void EdgeDerivatives::clear(int entry) {
  gradient_[entry] = {0, 0, 0};
  for (int k = 0; k < edge_band_blocks; ++k) {
    blocks_[entry * edge_band_blocks + k] = Matrix3<Pack>::zero();
  }
}

Vector3<Pack> EdgeDerivatives::take_row(int i, Matrix3<Pack>* hessian_row) {
  const Vector3<Pack> gradient_row = gradient_[i] - gradient_[i + 1];
  write_hessian_row(i, hessian_row);
  clear(i);
  taken_ = i + 1;
  return gradient_row;
}

EdgeOutputs EdgeDerivatives::outputs() {
  return {std::span(gradient_).subspan(1, vertices_),
          EdgeBands(std::span(blocks_).subspan(edge_band_blocks, vertices_ * edge_band_blocks))};
}

// With (i, k) for the block of H at edges i and i - k, row i of D^T H D has the blocks
//
//     (i-1, 0) + (i, 0) - (i, 1) - (i, 1)^T,  (i-1, 1) + (i, 1) - (i, 2) - (i-1, 0),
//     (i-1, 2) + (i, 2) - (i-1, 1),           -(i-1, 2)
void EdgeDerivatives::write_hessian_row(int i, Matrix3<Pack>* row) const {
  const Matrix3<Pack>* before = &blocks_[i * edge_band_blocks];
  const Matrix3<Pack>* own = before + edge_band_blocks;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) {
      const auto lower = std::max(r, c), upper = std::min(r, c);
      const Pack& diagonal = before[0](lower, upper);
      if (r >= c) {
        const Pack entry = diagonal + own[0](r, c) - own[1](r, c) - own[1](c, r);
        row[0](r, c) = row[0](c, r) = entry;
      }
      row[1](r, c) = before[1](r, c) + own[1](r, c) - own[2](r, c) - diagonal;
      row[2](r, c) = before[2](r, c) + own[2](r, c) - before[1](r, c);
      row[3](r, c) = -before[2](r, c);
    }
  }
}

void EdgeDerivatives::add_to(const GroupOutputs& outputs) {
  for (int i = 0; i < vertices_; ++i) {
    Matrix3<Pack> row[band_blocks];
    const Vector3<Pack> gradient_row = take_row(i, row);
    if (!outputs.gradient.empty()) outputs.gradient[i] += gradient_row;
    if (outputs.hessian.empty()) continue;
    for (int k = 0; k <= std::min(i, band_blocks - 1); ++k) outputs.hessian.block(i, k) += row[k];
  }
}

}  // namespace ringlet
