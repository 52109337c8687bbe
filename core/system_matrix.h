#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <vector>

#include "core/couplings.h"
#include "core/edge_derivatives.h"
#include "core/strand_bands.h"
#include "core/vertex_field.h"

namespace ringlet {

/// The matrix of a Newton step: a block band a strand, plus blocks that couple strands. Symmetric;
/// pinned vertices are identity, pads a multiple of it.
class SystemMatrix {
 public:
  explicit SystemMatrix(const StrandGroups& groups) : couplings(groups), groups_(&groups) {
    couplings.clear();
  }

  const StrandGroups& groups() const { return *groups_; }
  bool couples_strands() const { return couplings.coupled_count() > 0; }

  /// Memory for the bands of all groups; without it there are none.
  void keep_bands() {
    if (!has_bands_) bands = StrandBands(*groups_);
    has_bands_ = true;
  }
  /// Memory for the bands of one group, in the calling thread alone, until the next call.
  GroupBands temporary_bands(int group);
  /// Memory for a vector over the rows of one group, likewise; there are two of them.
  std::span<Vector3<Pack>> temporary_gradient(int group);
  std::span<Vector3<Pack>> temporary_direction(int group);
  /// Zero derivatives over the edges of one group, in the calling thread alone, until the next
  /// call.
  EdgeDerivatives& temporary_edges(int group);

  /// The memory that it holds.
  std::size_t bytes() const;

  StrandBands bands;
  Couplings couplings;

 private:
  const StrandGroups* groups_;
  bool has_bands_ = false;
  struct Temporary {
    std::vector<Matrix3<Pack>> blocks;
    EdgeDerivatives edges;
    std::vector<Vector3<Pack>> gradient, direction;
  };
  std::span<Vector3<Pack>> rows_of(int group, std::vector<Vector3<Pack>>& vector) const;
  tbb::enumerable_thread_specific<Temporary> temporary_;
};

/// y = A x; deterministic for any number of threads. The bands must have been kept.
void multiply(const SystemMatrix& a, const VertexField& x, VertexField& y);
/// The rows of one group of that.
void multiply_group(const SystemMatrix& a, int group, const VertexField& x, VertexField& y);

/// The rows of a group: 1 for a free vertex and 0 for a pinned one or a pad, and whether a row
/// holds a pinned one.
struct PinnedRows {
  std::span<const Pack> free;
  std::span<const char> has_pins;
};
/// Makes some rows, and all columns in them, of pinned vertices those of the identity, and adds it
/// to those of pads, which have nothing off the diagonal.
void pin_rows(GroupBands bands, RowRange rows, const PinnedRows& pinned);

}  // namespace ringlet
