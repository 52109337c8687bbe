#pragma once

#include <filesystem>
#include <fstream>
#include <span>
#include <vector>

#include "core/metrics.h"

namespace ringlet {

/// metrics.csv: a row a step, complete on disk when the step ends.
class MetricsFile {
 public:
  /// Throws Error if the file cannot be written; append() does, too.
  MetricsFile(const std::filesystem::path& path, std::span<const Metric> metrics);
  /// Goes on with a file after a step; what it has of later ones is cut off.
  MetricsFile(const std::filesystem::path& path, int step);
  /// What was not measured, not a number, leaves its cell empty.
  void append(std::span<const double> row);

 private:
  void write_line(const std::string& line);

  std::filesystem::path path_;
  std::ofstream file_;
};

}  // namespace ringlet
