#include "apps/study/front.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace ringlet {
namespace {

constexpr int loosest_decade = 3, tightest_decade = -15;

/// 0.003 m as 3 mm.
std::string with_unit(double value, const std::string& unit) {
  if (unit.empty()) return fmt::format("{:.2g} %", 100 * value);
  if (unit != "m") return fmt::format("{:.2g} {}", value, unit);
  for (const auto& [scale, name] :
       {std::pair{1.0, "m"}, {1e-2, "cm"}, {1e-3, "mm"}, {1e-6, "um"}}) {
    if (value >= 0.999 * scale) return fmt::format("{:.3g} {}", value / scale, name);
  }
  return fmt::format("{:.3g} nm", value * 1e9);
}

std::string seconds_in_words(double seconds) {
  return seconds < 1 ? fmt::format("{:.3g} ms", 1e3 * seconds) : fmt::format("{:.3g} s", seconds);
}

std::string compare(const TradePoint& point, const TradePoint& as_it_stands) {
  if (point.name == as_it_stands.name) return "the scene as it stands";
  const double ratio = as_it_stands.seconds / point.seconds;
  const std::string speed = ratio >= 1 ? fmt::format("{:.2g} times faster", ratio)
                                       : fmt::format("{:.2g} times slower", 1 / ratio);
  return speed + " than the scene as it stands";
}

}  // namespace

std::vector<TradePoint> pareto_front(std::vector<TradePoint> points) {
  std::sort(points.begin(), points.end(), [](const TradePoint& a, const TradePoint& b) {
    return std::tie(a.seconds, a.error, a.name) < std::tie(b.seconds, b.error, b.name);
  });
  std::vector<TradePoint> front;
  for (TradePoint& point : points) {
    if (front.empty() || point.error < front.back().error) front.push_back(std::move(point));
  }
  return front;
}

std::vector<std::string> recommend(const std::vector<TradePoint>& front,
                                   const std::optional<TradePoint>& as_it_stands,
                                   const std::string& unit) {
  std::vector<std::string> words;
  std::string last;
  for (int decade = loosest_decade; decade >= tightest_decade; --decade) {
    for (const double mantissa : {3.0, 1.0}) {
      const double bound = mantissa * std::pow(10.0, decade);
      const auto found = std::find_if(front.begin(), front.end(), [&](const TradePoint& point) {
        return point.error <= bound;
      });
      // Only the tightest bound that a point keeps is said of it.
      const double next = mantissa == 3.0 ? bound / 3 : 0.3 * bound;
      if (found == front.end() || found->name == last || found->error <= next) continue;
      last = found->name;
      words.push_back(
          fmt::format("for errors under {}: {} ({}, {}{})", with_unit(bound, unit), found->name,
                      seconds_in_words(found->seconds), with_unit(found->error, unit),
                      as_it_stands ? "; " + compare(*found, *as_it_stands) : std::string()));
    }
  }
  return words;
}

}  // namespace ringlet
