#include "core/edge_derivatives.h"

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

EdgeOutputs EdgeDerivatives::outputs() {
  return {std::span(gradient_).subspan(1, vertices_),
          EdgeBands(std::span(blocks_).subspan(edge_band_blocks, vertices_ * edge_band_blocks))};
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
