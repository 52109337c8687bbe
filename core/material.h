#pragma once

#include <numbers>
#include <optional>

namespace ringlet {

/// The elastic material and cross-section of a strand, in SI units. The cross-section is a full
/// circle whose radius goes linearly from root to tip along the strand.
struct Material {
  double youngs_modulus = 3.9e9;          ///< E, Pa
  std::optional<double> shear_modulus{};  ///< G, Pa; E / 2(1 + nu) if absent
  double poisson_ratio = 0.5;             ///< nu; only used where the shear modulus is absent
  double density = 1300;                  ///< kg/m^3
  double radius = 4e-5;                   ///< m, at the root
  std::optional<double> tip_radius{};     ///< m; that of the root if absent

  double shear() const {
    return shear_modulus.value_or(youngs_modulus / (2 * (1 + poisson_ratio)));
  }
};

/// Moments of a full circle of radius r: A = pi r^2, I = pi r^4 / 4, J = pi r^4 / 2 = 2 I.
inline double circle_area(double r) { return std::numbers::pi * r * r; }
inline double circle_second_moment(double r) { return std::numbers::pi * r * r * r * r / 4; }
inline double circle_polar_moment(double r) { return 2 * circle_second_moment(r); }

}  // namespace ringlet
