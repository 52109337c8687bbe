#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/parameters.h"

namespace ringlet {

/// frames.bin: the first words, the length of a header (8 bytes), the header (JSON), the radii (a
/// float a vertex, m), CRC-32 of header and radii (uint64), and frames of one size, appended one by
/// one:
///
///     step (int64), time (double, s), positions (3 numbers a vertex, m), CRC-32 of these (uint64)
///
/// in the byte order of the machine, which is little endian. What is on disk is whole up to the
/// last complete frame, however the writer ended.
inline constexpr char frames_first_words[] = "ringlet frames 2";  // 16 bytes without the end

enum class FramePrecision { twice, single };

template <>
struct EnumNames<FramePrecision> {
  static constexpr std::pair<FramePrecision, const char*> names[] = {
      {FramePrecision::twice, "double"}, {FramePrecision::single, "single"}};
};

/// What does not change from frame to frame.
struct FramesHeader {
  std::vector<int> vertex_counts;  ///< of each strand
  FramePrecision precision = FramePrecision::twice;

  static Schema<FramesHeader> schema() {
    return Schema<FramesHeader>()
        .required("vertex_counts", &FramesHeader::vertex_counts, "", at_least(2), "of each strand")
        .required("precision", &FramesHeader::precision, "", any_number(), "of the positions");
  }
  bool operator==(const FramesHeader&) const = default;
  std::int64_t vertex_count() const;
  std::int64_t radii_bytes() const { return 4 * vertex_count(); }
  /// Of a frame with its checksum.
  std::int64_t frame_bytes() const;
};

/// CRC-32 as zlib computes it.
std::uint64_t checksum(const std::string& bytes);

}  // namespace ringlet
