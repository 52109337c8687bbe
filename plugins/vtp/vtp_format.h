#pragma once

#include <ostream>

#include "core/parameters.h"
#include "core/state.h"
#include "core/strands.h"

namespace ringlet {

/// How numbers stand in a .vtp file.
enum class VtpEncoding { binary, ascii };

template <>
struct EnumNames<VtpEncoding> {
  static constexpr std::pair<VtpEncoding, const char*> names[] = {{VtpEncoding::binary, "binary"},
                                                                  {VtpEncoding::ascii, "ascii"}};
};

/// Writes the strands as VTK XML PolyData: a polyline a strand; at the vertices Points (m),
/// radius (m), velocity (m/s) and the number of the strand; the time (s) as field TimeValue.
/// Coordinates are 32-bit floats. Binary: raw appended data, a 64-bit byte count before each array.
void write_vtp(const Strands& strands, const State& state, VtpEncoding encoding,
               std::ostream& stream);

}  // namespace ringlet
