#include "plugins/render/sample_pattern.h"

#include <algorithm>
#include <cmath>

#include "plugins/render/hash.h"

namespace ringlet {
namespace {

/// The root of x^7 = x + 1.
constexpr double root = 1.1127756842787054;

constexpr std::array<double, sample_dimensions> make_steps() {
  std::array<double, sample_dimensions> steps{};
  double power = 1;
  for (double& step : steps) step = power /= root;
  return steps;
}
constexpr std::array<double, sample_dimensions> steps = make_steps();

}  // namespace

SamplePattern::SamplePattern(std::uint64_t pixel) : shift_{} {
  for (int d = 0; d < sample_dimensions; ++d) {
    shift_[d] = hashed_uniform(pixel, static_cast<std::uint64_t>(d));
  }
}

float SamplePattern::operator()(int sample, int dimension) const {
  const double moved = shift_[dimension] + sample * steps[dimension];
  // The rounding to float must not lead to 1.
  return std::min(static_cast<float>(moved - std::floor(moved)), 1 - 0x1p-24F);
}

}  // namespace ringlet
