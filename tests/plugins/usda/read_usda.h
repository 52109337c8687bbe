#pragma once

#include <string>
#include <vector>

namespace ringlet {

/// What stands in a run.usda, read independently of ringlet's reader, line by line: anything that
/// the writer should not write throws std::runtime_error.
struct UsdaContent {
  double start = 0, end = 0, time_codes_per_second = 0;
  std::vector<int> vertex_counts;
  std::vector<float> widths;
  std::vector<double> time_codes;
  std::vector<std::vector<float>> points;  ///< of each time code, x, y, z a vertex
  std::vector<float> extent;               ///< of the box: the lower corner, the upper corner
};

UsdaContent read_usda(const std::string& text);

}  // namespace ringlet
