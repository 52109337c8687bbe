#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace ringlet {

/// Coordinates as 16-bit steps from the low corner of a box.
struct Quantisation {
  std::array<double, 3> low{};   ///< m
  std::array<double, 3> step{};  ///< m, a 65,535th of the side

  /// The box around all positions, x, y, z a vertex.
  static Quantisation around(const std::vector<std::vector<float>>& frames);
  std::array<double, 3> centre() const;  ///< m, of the box
  /// The nearest step to each coordinate.
  std::vector<std::uint16_t> quantise(const std::vector<float>& positions) const;
};

/// Frames of quantised positions as text, so that the page can read them (page/src/decode.js says
/// how they stand there). `first` is the first vertex of each strand and, at its end, the number of
/// vertices.
std::string pack_frames(const std::vector<std::vector<std::uint16_t>>& frames,
                        const std::vector<int>& first);

}  // namespace ringlet
