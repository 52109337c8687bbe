#include "apps/metrics_file.h"

#include <spdlog/fmt/fmt.h>

#include <cmath>

#include "core/error.h"
#include "core/keep_lines.h"

namespace ringlet {

MetricsFile::MetricsFile(const std::filesystem::path& path, std::span<const Metric> metrics)
    : path_(path), file_(path) {
  std::vector<std::string> names;
  for (const Metric& metric : metrics) names.push_back(metric.name);
  write_line(fmt::format("{}\n", fmt::join(names, ",")));
}

MetricsFile::MetricsFile(const std::filesystem::path& path, int step) : path_(path) {
  const int head = 1;
  keep_lines(path, head + step);
  file_.open(path, std::ios::app);
}

void MetricsFile::append(std::span<const double> row) {
  std::vector<std::string> cells;
  for (const double value : row) {
    cells.push_back(std::isnan(value) ? "" : fmt::format("{}", value));
  }
  write_line(fmt::format("{}\n", fmt::join(cells, ",")));
}

void MetricsFile::write_line(const std::string& line) {
  file_ << line << std::flush;
  if (!file_) throw Error("cannot write '" + path_.string() + "'");
}

}  // namespace ringlet
