#pragma once

#include <filesystem>
#include <span>

#include "core/metrics.h"
#include "core/parameters.h"

namespace ringlet {

/// {"step": 1, "time": ..., ...}: a row of metrics.csv on stdout; null is what was not measured.
void print_step_line(std::span<const Metric> metrics, std::span<const double> row);

/// {"summary": {...}, "folder": "..."}: the last line of a run, its summary.json.
void print_summary_line(const Json& summary, const std::filesystem::path& folder);

}  // namespace ringlet
