#pragma once

#include <span>
#include <vector>

#include "apps/report/metrics_table.h"
#include "core/metrics.h"

namespace ringlet {

/// What the record of a run keeps of a step.
struct RecordedStep {
  StepReport report;
  double seconds;  ///< that the step took
};

/// From a row of metrics.csv: for a run that goes on where another process left it.
RecordedStep recorded_step(std::span<const Metric> metrics, std::span<const double> row);

/// The rows of a metrics.csv up to a step. Throws Error if it has other columns, or not so many.
std::vector<std::vector<double>> read_rows(const MetricsTable& table,
                                           std::span<const Metric> metrics, int steps);

}  // namespace ringlet
