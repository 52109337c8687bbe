#include "apps/json_lines.h"

#include <spdlog/fmt/fmt.h>

#include <cmath>
#include <cstdio>

namespace ringlet {
namespace {

void print_line(const Json& json) {
  fmt::print("{}\n", json.dump(-1, ' ', false, Json::error_handler_t::replace));
  std::fflush(stdout);
}

}  // namespace

void print_step_line(std::span<const Metric> metrics, std::span<const double> row) {
  Json line = Json::object();
  for (std::size_t i = 0; i < metrics.size(); ++i) {
    line[metrics[i].name] = std::isfinite(row[i]) ? Json(row[i]) : Json();
  }
  print_line(line);
}

void print_summary_line(const Json& summary, const std::filesystem::path& folder) {
  print_line({{"summary", summary}, {"folder", folder.string()}});
}

}  // namespace ringlet
