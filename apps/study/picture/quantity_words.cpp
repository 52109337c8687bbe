#include "apps/study/picture/quantity_words.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace ringlet {
namespace {

constexpr std::array<std::string_view, 11> prefixes{"f", "p", "n", "µ", "m", "",
                                                    "k", "M", "G", "T", "P"};
constexpr int without_prefix = 5;

bool takes_prefix(const std::string& unit) {
  return unit == "m" || unit == "s" || unit == "J" || unit == "N" || unit == "B";
}

}  // namespace

std::string quantity_words(double value, const std::string& unit) {
  if (value == 0 || !std::isfinite(value) || !takes_prefix(unit)) {
    return fmt::format("{:.3g}{}{}", value, unit.empty() ? "" : " ", unit);
  }
  // The exponent once the number is rounded: 999.9 counts as 1000.
  const std::string rounded = fmt::format("{:.2e}", value);
  const int exponent = std::stoi(rounded.substr(rounded.find('e') + 1));
  const int thousands = std::clamp(static_cast<int>(std::floor(exponent / 3.0)), -without_prefix,
                                   static_cast<int>(prefixes.size()) - 1 - without_prefix);
  return fmt::format("{:.3g} {}{}", std::stod(rounded) * std::pow(10.0, -3 * thousands),
                     prefixes[static_cast<std::size_t>(thousands + without_prefix)], unit);
}

}  // namespace ringlet
