#include "apps/study/picture/symbols.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace ringlet {
namespace {

using Channels = std::array<double, 3>;

constexpr std::array<const char*, 8> kinds{"#3b82f6", "#e0793a", "#16a085", "#c2569b",
                                           "#8b7bd8", "#a8921f", "#d0504f", "#4aa3b8"};
/// From the first value to the last: orange, red, magenta, violet, blue.
constexpr std::array<Channels, 5> ramp{
    {{217, 127, 47}, {208, 55, 90}, {194, 58, 192}, {122, 66, 214}, {59, 98, 214}}};
/// Circle, square, triangles, diamond, pentagon; one less is hollow.
constexpr std::array<int, 6> filled_symbols{7, 5, 9, 11, 13, 15};

bool is_number(const std::string& text) {
  char* end = nullptr;
  std::strtod(text.c_str(), &end);
  return !text.empty() && *end == '\0';
}

std::string ramp_colour(double share) {
  const double place = share * (ramp.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), ramp.size() - 2);
  const double part = place - static_cast<double>(below);
  const auto channel = [&](std::size_t c) {
    return std::lround(ramp[below][c] + part * (ramp[below + 1][c] - ramp[below][c]));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", channel(0), channel(1), channel(2));
}

}  // namespace

std::vector<std::string> colours_for(const std::vector<std::string>& values) {
  const std::size_t count = values.size();
  if (count <= kinds.size() && !std::all_of(values.begin(), values.end(), is_number)) {
    return {kinds.begin(), kinds.begin() + static_cast<std::ptrdiff_t>(count)};
  }
  std::vector<std::string> colours;
  for (std::size_t i = 0; i < count; ++i) {
    colours.push_back(
        ramp_colour(count > 1 ? static_cast<double>(i) / static_cast<double>(count - 1) : 0));
  }
  return colours;
}

int symbol_for(int index, bool filled) {
  return filled_symbols[static_cast<std::size_t>(std::max(index, 0)) % filled_symbols.size()] -
         (filled ? 0 : 1);
}

}  // namespace ringlet
