#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace ringlet {

/// Linear red, green and blue of a colour in sRGB, both in [0, 1].
Eigen::Array3f linear(const Eigen::Vector3d& srgb);

/// The other way, in 0 to 255.
std::uint8_t to_srgb_byte(float linear);

/// Brings light of any strength into [0, 1]: leaves what is dark as it is, and rolls off what is
/// bright, so that highlights keep their shape.
Eigen::Array3f tone_mapped(const Eigen::Array3f& light);

}  // namespace ringlet
