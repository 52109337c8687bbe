#pragma once

#include <vector>

namespace ringlet {

/// The ends of a logarithmic axis and the round numbers that are marked on it.
struct LogRange {
  double low, high;
  std::vector<double> ticks;

  /// With a margin around some positive values.
  static LogRange around(const std::vector<double>& values);
};

}  // namespace ringlet
