#include "plugins/frames/frames_format.h"

#include <zlib.h>

#include <numeric>

namespace ringlet {

std::int64_t FramesHeader::vertex_count() const {
  return std::accumulate(vertex_counts.begin(), vertex_counts.end(), std::int64_t{0});
}

std::int64_t FramesHeader::frame_bytes() const {
  const std::int64_t number = precision == FramePrecision::single ? 4 : 8;
  return 8 + 8 + 3 * number * vertex_count() + 8;
}

std::uint64_t checksum(const std::string& bytes) {
  return crc32_z(crc32_z(0, nullptr, 0), reinterpret_cast<const Bytef*>(bytes.data()),
                 bytes.size());
}

}  // namespace ringlet
