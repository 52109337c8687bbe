#include "apps/render/chosen_frames.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <charconv>

#include "core/error.h"

namespace ringlet {
namespace {

std::string tell(const std::vector<int>& steps) {
  if (steps.size() == 1) return fmt::format("there is only that of step {}", steps.front());
  return fmt::format("there are {}, of steps {} to {}", steps.size(), steps.front(), steps.back());
}

/// Three numbers; the last is 1 if absent.
std::optional<std::array<int, 3>> read_range(const std::string& text) {
  std::array<int, 3> numbers{0, 0, 1};
  const char* at = text.data();
  const char* const end = at + text.size();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto [after, error] = std::from_chars(at, end, numbers[i]);
    if (error != std::errc()) return {};
    at = after;
    if (at == end) return i == 0 ? std::nullopt : std::optional(numbers);
    if (*at++ != ':') return {};
  }
  return {};
}

std::vector<int> one_frame(const std::vector<int>& steps, int step) {
  const auto found = std::lower_bound(steps.begin(), steps.end(), step);
  if (found == steps.end() || *found != step) {
    throw Error(fmt::format("--frame {}: there is no such frame; {}", step, tell(steps)));
  }
  return {static_cast<int>(found - steps.begin())};
}

std::vector<int> frames_of(const std::vector<int>& steps, const std::string& text) {
  const auto range = read_range(text);
  if (!range || (*range)[2] < 1) {
    throw Error("--frames '" + text + "': expected A:B or A:B:EVERY, steps, with EVERY >= 1");
  }
  const auto [from, to, every] = *range;
  std::vector<int> numbers;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const bool inside = steps[i] >= from && steps[i] <= to;
    if (inside && (steps[i] - from) % every == 0) numbers.push_back(static_cast<int>(i));
  }
  if (numbers.empty()) {
    throw Error("--frames " + text + ": there is no such frame; " + tell(steps));
  }
  return numbers;
}

}  // namespace

std::vector<int> chosen_frames(const std::vector<int>& steps, std::optional<int> frame,
                               const std::optional<std::string>& range) {
  if (frame && range) throw Error("expected --frame or --frames, not both");
  if (frame) return one_frame(steps, *frame);
  if (range) return frames_of(steps, *range);
  return {static_cast<int>(steps.size()) - 1};
}

}  // namespace ringlet
