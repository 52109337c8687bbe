#include "apps/bench/timing.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace ringlet {
namespace {

double quantile(const std::vector<double>& sorted, double part) {
  return sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1))];
}

}  // namespace

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return quantile(values, 0.5);
}

Timing summarise(std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  return {quantile(seconds, 0.5), quantile(seconds, 0.75) - quantile(seconds, 0.25)};
}

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
  return summarise(std::move(durations));
}

}  // namespace ringlet
