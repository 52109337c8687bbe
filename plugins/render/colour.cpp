#include "plugins/render/colour.h"

#include <algorithm>
#include <cmath>

namespace ringlet {
namespace {

double to_linear(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }

/// Above this, light is compressed.
constexpr float knee = 0.6F;

float compress(float c) {
  if (c <= knee) return std::max(c, 0.0F);
  return knee + (1 - knee) * (1 - std::exp(-(c - knee) / (1 - knee)));
}

}  // namespace

Eigen::Array3f linear(const Eigen::Vector3d& srgb) {
  return srgb.unaryExpr(&to_linear).cast<float>().array();
}

std::uint8_t to_srgb_byte(float linear) {
  const float c = std::clamp(linear, 0.0F, 1.0F);
  const float srgb = c <= 0.0031308F ? 12.92F * c : 1.055F * std::pow(c, 1 / 2.4F) - 0.055F;
  return static_cast<std::uint8_t>(std::lround(255 * srgb));
}

Eigen::Array3f tone_mapped(const Eigen::Array3f& light) {
  return light.unaryExpr([](float c) { return compress(c); });
}

}  // namespace ringlet
