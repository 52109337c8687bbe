#include "apps/bench/timing.h"

#include <algorithm>
#include <chrono>
#include <vector>

namespace ringlet {

Timing measure(const std::function<void()>& function, double seconds) {
  using Clock = std::chrono::steady_clock;
  const auto since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  constexpr std::size_t least = 5;
  if (seconds > 0) function();
  std::vector<double> durations;
  const Clock::time_point begin = Clock::now();
  do {
    const Clock::time_point start = Clock::now();
    function();
    durations.push_back(since(start));
  } while (seconds > 0 && (durations.size() < least || since(begin) < seconds));
  std::sort(durations.begin(), durations.end());
  const auto quantile = [&](double part) {
    return durations[static_cast<std::size_t>(part * static_cast<double>(durations.size() - 1))];
  };
  return {quantile(0.5), quantile(0.75) - quantile(0.25)};
}

}  // namespace ringlet
