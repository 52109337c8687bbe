#pragma once

#include "core/coupling_blocks.h"
#include "core/strand_bands.h"
#include "core/vertex_field.h"

namespace ringlet {

/// The matrix of a Newton step: a block band a strand, plus blocks that couple strands. Symmetric;
/// pinned vertices and pads are identity.
struct SystemMatrix {
  explicit SystemMatrix(const StrandGroups& groups) : bands(groups), couplings(groups) {
    couplings.clear();
  }

  const StrandGroups& groups() const { return bands.groups(); }
  bool couples_strands() const { return couplings.off_band_count() > 0; }

  StrandBands bands;
  CouplingBlocks couplings;
};

/// y = A x; deterministic for any number of threads.
void multiply(const SystemMatrix& a, const VertexField& x, VertexField& y);

/// Makes the rows and columns of pinned vertices and pads those of the identity. free holds 1 for a
/// free vertex and 0 for a pinned one or a pad.
void pin_rows(GroupBands bands, std::span<const Pack> free);

}  // namespace ringlet
