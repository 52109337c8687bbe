#include "core/system_matrix.h"

#include <algorithm>

#include "core/parallel.h"

namespace ringlet {

GroupBands SystemMatrix::temporary_bands(int group) {
  std::vector<Matrix3<Pack>>& blocks = temporary_.local().blocks;
  const std::size_t size = static_cast<std::size_t>((*groups_)[group].vertices) * band_blocks;
  if (blocks.size() < size) blocks.resize(size);
  return GroupBands(std::span(blocks).first(size));
}

std::span<Vector3<Pack>> SystemMatrix::rows_of(int group,
                                               std::vector<Vector3<Pack>>& vector) const {
  const std::size_t size = (*groups_)[group].vertices;
  if (vector.size() < size) vector.resize(size);
  return std::span(vector).first(size);
}

std::span<Vector3<Pack>> SystemMatrix::temporary_gradient(int group) {
  return rows_of(group, temporary_.local().gradient);
}

std::span<Vector3<Pack>> SystemMatrix::temporary_direction(int group) {
  return rows_of(group, temporary_.local().direction);
}

EdgeDerivatives& SystemMatrix::temporary_edges(int group) {
  EdgeDerivatives& edges = temporary_.local().edges;
  edges.begin((*groups_)[group].vertices);
  return edges;
}

std::size_t SystemMatrix::bytes() const {
  std::size_t sum = bands.bytes() + couplings.bytes();
  for (const Temporary& temporary : temporary_) {
    sum += bytes_of(temporary.blocks) + temporary.edges.bytes() + bytes_of(temporary.gradient) +
           bytes_of(temporary.direction);
  }
  return sum;
}

void multiply(const SystemMatrix& a, const VertexField& x, VertexField& y) {
  parallel_for_each(a.groups().count(), [&](int g) { multiply_group(a, g, x, y); });
}

void multiply_group(const SystemMatrix& a, int group, const VertexField& x, VertexField& y) {
  const auto rows = y.group(group);
  std::fill(rows.begin(), rows.end(), Vector3<Pack>{0, 0, 0});
  add_band_product(a.bands, group, x.group(group), rows);
  if (a.couples_strands()) a.couplings.add_product(group, x, y);
}

void pin_rows(GroupBands bands, RowRange rows, const PinnedRows& pinned) {
  const auto& [free, has_pins] = pinned;
  // Most rows, and all that they couple to, are free.
  int last_pinned = -band_blocks;
  for (int i = std::max(rows.first - band_blocks + 1, 0); i < rows.end; ++i) {
    if (has_pins[i]) last_pinned = i;
    if (i < rows.first) continue;
    if (i - last_pinned < band_blocks) {
      for (int k = 0; k <= std::min(i, band_blocks - 1); ++k) {
        const Pack both = free[i] * free[i - k];
        bands.block(i, k) = both * bands.block(i, k);
      }
    }
    if (any(free[i] != 1)) {
      for (int c = 0; c < 3; ++c) bands.block(i, 0)(c, c) += 1 - free[i];
    }
  }
}

}  // namespace ringlet
