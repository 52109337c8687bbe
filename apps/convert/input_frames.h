#pragma once

#include <functional>

#include "core/registry.h"
#include "plugins/run_frames.h"

namespace ringlet {

/// States of strands that are to be written again.
struct InputFrames {
  std::vector<int> vertex_counts;            ///< of each strand, >= 2
  std::vector<double> radii;                 ///< m; of each vertex
  std::vector<int> steps;                    ///< of the frames, ascending
  std::function<RunFrame(int number)> read;  ///< throws Error if the frame is damaged
};

/// How a file is read that knows nothing of metres or radii.
struct InputUnits {
  double scale = 1;      ///< m
  double radius = 4e-5;  ///< m
};

/// The extension of a path without the dot, in small letters.
std::string extension_of(const std::filesystem::path& path);

/// Those of a run folder, a .bin, .pvd or .usda; of any other file that a strand reader reads the
/// only one, whose step is 0. Throws Error if there is none.
InputFrames open_input(const std::filesystem::path& path, const InputUnits& units,
                       const Registry& registry);

/// The frame of a step alone. Throws Error if there is none.
InputFrames only_frame(const InputFrames& frames, int step);

}  // namespace ringlet
