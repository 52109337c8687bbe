#pragma once

#include <cstdint>
#include <vector>

namespace ringlet {

/// What of a run is shown: every so many frames, and the last; every so many strands.
struct Thinning {
  int every_frame = 1;
  int every_strand = 1;
};

/// Thins the positions of a run, 6 bytes a vertex and frame, to a budget: first frames, down to
/// `fewest_frames`, then strands. At least one strand and one frame stay.
Thinning thin(int frames, std::int64_t vertices, int strands, std::int64_t budget_bytes);

inline constexpr int fewest_frames = 60;

/// The numbers 0 to count - 1 that stay: every so many, and the last if wanted.
std::vector<int> kept(int count, int every, bool with_last);

}  // namespace ringlet
