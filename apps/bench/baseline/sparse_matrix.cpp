#include "apps/bench/baseline/sparse_matrix.h"

#include <algorithm>
#include <vector>

namespace ringlet {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

template <class Block>
void add_block(int i, int j, const Block& block, Triplets& triplets) {
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) triplets.emplace_back(3 * i + r, 3 * j + c, block(r, c));
  }
}

/// The blocks of a vertex with itself and the vertices before it, and their mirror images.
void add_band_row(const SystemMatrix& a, int vertex, Triplets& triplets) {
  const auto [row, lane] = a.groups().slot(vertex);
  const int left = row - a.groups()[a.groups().group_of(vertex)].first_row;
  for (int k = 0; k <= std::min(left, band_blocks - 1); ++k) {
    const Matrix3<Pack>& block = a.bands.block(row, k);
    const auto entry = [&, lane = lane](int r, int c) { return block(r, c)[lane]; };
    const auto mirrored = [&](int r, int c) { return entry(c, r); };
    add_block(vertex, vertex - k, entry, triplets);
    if (k > 0) add_block(vertex - k, vertex, mirrored, triplets);
  }
}

}  // namespace

Eigen::SparseMatrix<double> sparse_matrix(const SystemMatrix& a) {
  Triplets triplets;
  const int vertices = a.groups().vertex_count();
  for (int vertex = 0; vertex < vertices; ++vertex) add_band_row(a, vertex, triplets);
  a.couplings.for_each_off_band(
      [&](int i, int j, const Eigen::Matrix3d& block) { add_block(i, j, block, triplets); });
  Eigen::SparseMatrix<double> matrix(3 * vertices, 3 * vertices);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

}  // namespace ringlet
