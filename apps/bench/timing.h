#pragma once

#include <functional>

namespace ringlet {

/// How long one call takes, s.
struct Timing {
  double median;
  double spread;  ///< between the quartiles
};

/// Calls the function once to warm up, then again until the time is over, at least five times; once
/// if there is no time at all.
Timing measure(const std::function<void()>& function, double seconds);

}  // namespace ringlet
