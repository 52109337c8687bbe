#pragma once

#include <ostream>

#include "core/parameters.h"
#include "core/state.h"
#include "core/strands.h"

namespace ringlet {

/// How numbers stand in a .ply file.
enum class PlyEncoding { binary, ascii };

template <>
struct EnumNames<PlyEncoding> {
  static constexpr std::pair<PlyEncoding, const char*> names[] = {{PlyEncoding::binary, "binary"},
                                                                  {PlyEncoding::ascii, "ascii"}};
};

/// Writes the strands as vertices (x, y, z and radius, m) and edges (vertex1, vertex2). Coordinates
/// are 32-bit floats; binary is little endian.
void write_ply(const Strands& strands, const State& state, PlyEncoding encoding,
               std::ostream& stream);

}  // namespace ringlet
