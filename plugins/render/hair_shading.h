#pragma once

#include <Eigen/Core>
#include <numbers>

#include "plugins/render/render_parameters.h"

namespace ringlet {

inline constexpr float pi = std::numbers::pi_v<float>;

/// Red, green and blue, linear.
using Rgb = Eigen::Array3f;

/// How a hair scatters light: the model of Marschner et al., "Light Scattering from Human Hair
/// Fibers", SIGGRAPH 2003, with lobes that are cheap to evaluate: R is reflected at the surface,
/// TT goes through the hair, TRT is reflected at its back. Cuticles tilt the lobes along the hair,
/// so that there are two highlights, a white one and a coloured one. What many hairs scatter to
/// each other is a diffuse lobe of the colour of much hair (J. T. Kajiya and T. L. Kay, SIGGRAPH
/// 1989). Absorption by melanin: E. d'Eon et al., "An Energy-Conserving Hair Reflectance Model",
/// EGSR 2011.
class HairShading {
 public:
  explicit HairShading(const RenderParameters& parameters);

  /// The light scattered to the eye, of light of radiance 1 from a solid angle of 1. All directions
  /// have length 1: of the hair towards its tip, to the light and to the eye. `darker` scales the
  /// absorption of this hair. A light that is wide, rad, needs few samples if its lobes are as
  /// wide.
  Rgb scattered(const Eigen::Vector3f& tangent, const Eigen::Vector3f& to_light,
                const Eigen::Vector3f& to_eye, float darker, float width) const;
  /// The part of the light that goes on straight behind one hair.
  float transmitted() const { return transmitted_; }

 private:
  Rgb absorption_;  // along the diameter of a hair
  Rgb diffuse_;
  float transmitted_;
};

}  // namespace ringlet
