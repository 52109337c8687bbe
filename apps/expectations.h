#pragma once

#include <span>
#include <vector>

#include "core/metrics.h"
#include "core/scene.h"

namespace ringlet {

/// What became of a bound that a scene expects its run to meet.
struct ExpectationResult {
  Expectation expectation;
  std::optional<double> value;  ///< absent: the run never came to that step

  /// A value that is not a number meets nothing.
  bool met() const;
};

/// The expectations of a step, looked up in its row of metrics.
std::vector<ExpectationResult> check_step(std::span<const Expectation> expectations, int step,
                                          std::span<const Metric> metrics,
                                          std::span<const double> row);

/// "step 300: mean_rest_distance = 0.02, expected <= 0.01", for the log.
std::string describe(const ExpectationResult& result);

}  // namespace ringlet
