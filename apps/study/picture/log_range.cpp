#include "apps/study/picture/log_range.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace ringlet {
namespace {

/// Leading digits of ticks, fewer over more decades.
std::vector<double> leading_digits(double decades) {
  if (decades < 0.7) return {1, 1.2, 1.4, 1.6, 1.8, 2, 2.5, 3, 3.5, 4, 5, 6, 7, 8, 9};
  if (decades < 1.3) return {1, 1.5, 2, 3, 4, 5, 7};
  if (decades < 3.2) return {1, 2, 5};
  return {1};
}

}  // namespace

LogRange LogRange::around(const std::vector<double>& values) {
  LogRange range{0.1, 1, {}};
  if (!values.empty()) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const double factor = std::max(std::pow(*high / *low, 0.06), 1.3);
    range.low = *low / factor;
    range.high = *high * factor;
  }
  const double decades = std::log10(range.high / range.low);
  const int every = std::max(1, static_cast<int>(std::ceil(decades / 9)));
  const int last = static_cast<int>(std::ceil(std::log10(range.high)));
  for (int power = static_cast<int>(std::floor(std::log10(range.low))); power <= last; ++power) {
    if (std::abs(power) % every != 0) continue;
    for (const double digit : leading_digits(decades)) {
      const double tick = digit * std::pow(10.0, power);
      if (tick >= range.low && tick <= range.high) range.ticks.push_back(tick);
    }
  }
  return range;
}

}  // namespace ringlet
