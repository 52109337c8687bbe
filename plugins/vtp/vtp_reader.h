#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace ringlet {

/// Of a frame that write_vtp() wrote, what is needed to show it.
struct VtpFrame {
  double time = 0;                    ///< s
  std::vector<float> points;          ///< m; x, y, z a vertex, strand after strand
  std::vector<float> radii;           ///< m; one a vertex
  std::vector<std::int32_t> offsets;  ///< of each strand, one past its last vertex
};

/// Reads a frame of either encoding. Throws Error, which names the file, if it is not there, is not
/// whole, is none of ringlet's, comes from a machine of another byte order, or holds a coordinate
/// that is not finite.
VtpFrame read_vtp_frame(const std::filesystem::path& path);

}  // namespace ringlet
