#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ringlet {

/// metrics.csv of a run: a row a step.
struct MetricsTable {
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;  ///< not a number where a cell is empty

  std::size_t rows() const { return columns.empty() ? 0 : columns.front().size(); }
};

/// Reads the whole rows; a last one that is still being written is left out. Without a file the
/// table is empty.
MetricsTable read_metrics_table(const std::filesystem::path& path);

}  // namespace ringlet
