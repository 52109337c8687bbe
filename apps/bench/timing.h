#pragma once

#include <functional>
#include <vector>

namespace ringlet {

double median(std::vector<double> values);

/// How long one call takes, s.
struct Timing {
  double median;
  double spread;  ///< between the quartiles
};

/// Of calls that took so long.
Timing summarise(std::vector<double> seconds);

/// Calls the function once to warm up, then again until the time is over, at least five times; once
/// if there is no time at all.
Timing measure(const std::function<void()>& function, double seconds);

}  // namespace ringlet
