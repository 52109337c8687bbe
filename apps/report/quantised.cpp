#include "apps/report/quantised.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "apps/report/packed_text.h"

namespace ringlet {
namespace {

constexpr double largest_step = std::numeric_limits<std::uint16_t>::max();

/// Small numbers of either sign become small numbers.
std::uint16_t zigzag(std::uint16_t difference) {
  return static_cast<std::uint16_t>((difference << 1) ^ ((difference & 0x8000) != 0 ? 0xffff : 0));
}

/// Strands move as a whole: what a vertex does beyond the one before it is little.
void append_frame(const std::vector<std::uint16_t>& frame, const std::vector<std::uint16_t>& before,
                  const std::vector<int>& first, std::vector<std::uint8_t>& bytes) {
  const std::size_t begin = bytes.size(), vertices = frame.size() / 3;
  bytes.resize(begin + 2 * frame.size());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t strand = 0; strand + 1 < first.size(); ++strand) {
      std::uint16_t last = 0;
      for (int v = first[strand]; v < first[strand + 1]; ++v) {
        const std::size_t i = 3 * static_cast<std::size_t>(v) + axis;
        const auto change = static_cast<std::uint16_t>(frame[i] - before[i]);
        const std::uint16_t residual = zigzag(static_cast<std::uint16_t>(change - last));
        last = change;
        const std::size_t at = begin + axis * vertices + static_cast<std::size_t>(v);
        bytes[at] = static_cast<std::uint8_t>(residual & 0xff);
        bytes[at + frame.size()] = static_cast<std::uint8_t>(residual >> 8);
      }
    }
  }
}

}  // namespace

Quantisation Quantisation::around(const std::vector<std::vector<float>>& frames) {
  std::array<double, 3> low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (const auto& frame : frames) {
    for (std::size_t i = 0; i < frame.size(); ++i) {
      low[i % 3] = std::min(low[i % 3], double{frame[i]});
      high[i % 3] = std::max(high[i % 3], double{frame[i]});
    }
  }
  Quantisation box;
  box.low = low;
  for (int axis = 0; axis < 3; ++axis) box.step[axis] = (high[axis] - low[axis]) / largest_step;
  return box;
}

std::array<double, 3> Quantisation::centre() const {
  std::array<double, 3> at;
  for (int axis = 0; axis < 3; ++axis) at[axis] = low[axis] + 0.5 * largest_step * step[axis];
  return at;
}

std::vector<std::uint16_t> Quantisation::quantise(const std::vector<float>& positions) const {
  std::vector<std::uint16_t> steps(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const double size = step[i % 3];
    const double place = size > 0 ? (positions[i] - low[i % 3]) / size : 0;
    steps[i] = static_cast<std::uint16_t>(std::clamp(std::round(place), 0.0, largest_step));
  }
  return steps;
}

std::string pack_frames(const std::vector<std::vector<std::uint16_t>>& frames,
                        const std::vector<int>& first) {
  std::vector<std::uint8_t> bytes;
  std::vector<std::uint16_t> before(frames.front().size(), 0);
  for (const auto& frame : frames) {
    append_frame(frame, before, first, bytes);
    before = frame;
  }
  return pack_text(bytes);
}

}  // namespace ringlet
