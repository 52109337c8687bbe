#pragma once

#include <span>
#include <vector>

#include "core/strand_groups.h"
#include "core/vector3.h"

namespace ringlet {

/// A symmetric block-banded matrix a lane, of which the lower triangle is kept: block(i, k) is the
/// 3x3 block at (row i, column i - k), k = 0 .. blocks_a_row - 1. Blocks that would lie outside the
/// matrix (k > i) are not used. A view.
template <int blocks_a_row>
class BlockBands {
 public:
  BlockBands() = default;
  explicit BlockBands(std::span<Matrix3<Pack>> blocks) : blocks_(blocks) {}

  bool empty() const { return blocks_.empty(); }
  int rows() const { return static_cast<int>(blocks_.size()) / blocks_a_row; }
  Matrix3<Pack>& block(int row, int offset) const { return blocks_[row * blocks_a_row + offset]; }
  std::span<Matrix3<Pack>> blocks() const { return blocks_; }

 private:
  std::span<Matrix3<Pack>> blocks_;
};

/// No stencil reaches further along a strand than four vertices.
inline constexpr int band_blocks = 4;
/// The matrices of the strands of a group, a row a vertex.
using GroupBands = BlockBands<band_blocks>;

/// Where a term adds its derivatives with respect to the vertices of a group of strands; what is
/// empty is not wanted.
struct GroupOutputs {
  std::span<Vector3<Pack>> gradient;
  GroupBands hessian;
};

/// The bands of all groups.
class StrandBands {
 public:
  StrandBands() = default;
  explicit StrandBands(const StrandGroups& groups)
      : groups_(&groups), blocks_(groups.rows() * band_blocks, Matrix3<Pack>::zero()) {}

  const StrandGroups& groups() const { return *groups_; }
  GroupBands group(int g) {
    const StrandGroup& group = (*groups_)[g];
    return GroupBands(
        std::span(blocks_).subspan(group.first_row * band_blocks, group.vertices * band_blocks));
  }
  const Matrix3<Pack>& block(int row, int offset) const {
    return blocks_[row * band_blocks + offset];
  }
  std::size_t bytes() const { return blocks_.capacity() * sizeof(Matrix3<Pack>); }

 private:
  const StrandGroups* groups_ = nullptr;
  StreamedVector<Matrix3<Pack>> blocks_;
};

/// y += A x for the strands of one group.
void add_band_product(const StrandBands& bands, int group, std::span<const Vector3<Pack>> x,
                      std::span<Vector3<Pack>> y);

}  // namespace ringlet
