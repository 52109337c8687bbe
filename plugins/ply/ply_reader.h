#pragma once

#include "core/strand_reader.h"

namespace ringlet {

/// Strands of a .ply file, text or little endian: its vertices (x, y, z, and radius if it has
/// that), joined by its edges (vertex1, vertex2). Everything else in it is skipped.
class PlyReader final : public StrandReader {
 public:
  Polylines read(const std::filesystem::path& file) const override;
};

}  // namespace ringlet
