#pragma once

#include <Eigen/Core>
#include <bit>
#include <ostream>

namespace ringlet {

/// Writes a number as it stands in memory, where the low byte comes first.
template <class T>
void put(std::ostream& stream, const T& value) {
  static_assert(std::endian::native == std::endian::little);
  stream.write(reinterpret_cast<const char*>(&value), sizeof(T));
}

/// Three 32-bit floats.
inline void put_point(std::ostream& stream, const Eigen::Vector3d& x) {
  for (const double coordinate : x) put(stream, static_cast<float>(coordinate));
}

}  // namespace ringlet
