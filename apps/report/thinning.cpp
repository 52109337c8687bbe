#include "apps/report/thinning.h"

#include <algorithm>

namespace ringlet {
namespace {

constexpr std::int64_t bytes_per_vertex = 6;

std::int64_t divide_up(std::int64_t a, std::int64_t b) { return (a + b - 1) / b; }

/// Smallest number so that not more than `wanted` of `count` stay, beside the last.
int every_for(std::int64_t count, std::int64_t wanted) {
  return static_cast<int>(divide_up(count, std::max<std::int64_t>(wanted, 1)));
}

}  // namespace

Thinning thin(int frames, std::int64_t vertices, int strands, std::int64_t budget_bytes) {
  Thinning thinning;
  const std::int64_t frame_bytes = bytes_per_vertex * vertices;
  const std::int64_t affordable = std::max<std::int64_t>(budget_bytes / frame_bytes, fewest_frames);
  if (frames > affordable) thinning.every_frame = every_for(frames - 1, affordable - 1);
  const auto shown = static_cast<std::int64_t>(kept(frames, thinning.every_frame, true).size());
  const std::int64_t bytes = shown * frame_bytes;
  if (bytes > budget_bytes) {
    thinning.every_strand =
        static_cast<int>(std::min<std::int64_t>(divide_up(bytes, budget_bytes), strands));
  }
  return thinning;
}

std::vector<int> kept(int count, int every, bool with_last) {
  std::vector<int> numbers;
  for (int i = 0; i < count; i += every) numbers.push_back(i);
  if (with_last && numbers.back() != count - 1) numbers.push_back(count - 1);
  return numbers;
}

}  // namespace ringlet
