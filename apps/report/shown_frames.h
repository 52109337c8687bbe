#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "apps/report/contact_forces.h"
#include "apps/report/thinning.h"

namespace ringlet {

/// The frames of a run that its report shows.
struct ShownFrames {
  int count = 0;     ///< of frames in the run folder
  int strands = 0;   ///< of the run, all of them
  int vertices = 0;  ///< the same
  Thinning thinning;
  std::vector<int> steps;                     ///< at which the shown frames were written
  std::vector<double> times;                  ///< s
  std::vector<int> first;                     ///< of the shown strands, and the number of vertices
  std::vector<float> radii;                   ///< m, of the shown vertices
  std::vector<std::vector<float>> positions;  ///< m, a frame; x, y, z a shown vertex
  std::vector<std::vector<float>> contacts;   ///< N, a shown vertex; empty: not known
};

/// Reads the frames of a run folder, with contact forces if there is something that tells them,
/// thinned to a budget of quantised positions. Files that are not whole, as the last one of a run
/// that was cut off may be, are left out with a note. Throws Error if no frame is left.
ShownFrames read_shown_frames(const std::filesystem::path& folder, std::int64_t budget_bytes,
                              std::unique_ptr<ContactForces> contacts,
                              std::vector<std::string>& notes);

}  // namespace ringlet
