#include "plugins/render/hair_shading.h"

#include <algorithm>
#include <cmath>

#include "plugins/render/colour.h"

namespace ringlet {
namespace {

/// Tilt of the cuticle's scales, and widths of the lobes along the hair, rad.
constexpr float tilt = 0.05F;
constexpr float width_r = 0.14F, width_tt = 0.10F, width_trt = 0.24F;
/// Reflectance of keratin (index of refraction 1.55) at normal incidence.
constexpr float reflectance = 0.0465F;

/// As wide as two together.
float gaussian(float x, float width, float other_width) {
  const float squared = width * width + other_width * other_width;
  return std::exp(-0.5F * x * x / squared) / std::sqrt(2 * pi * squared);
}

/// Schlick's approximation.
float fresnel(float cosine) {
  const float rest = 1 - std::clamp(cosine, 0.0F, 1.0F);
  const float squared = rest * rest;
  return reflectance + (1 - reflectance) * squared * squared * rest;
}

/// Of much hair; the inverse of the fit of Chiang et al., "A Practical and Controllable Hair and
/// Fur Model for Production Path Tracing", CGF 35(2), 2016, for a roughness of 0.3.
constexpr float fit = 5.6F;
Rgb colour_of(const Rgb& absorption) { return (-fit * absorption.sqrt()).exp(); }
Rgb absorption_of(const Rgb& colour) {
  const Rgb root = colour.max(1e-4F).log() / fit;
  return root * root;
}

Rgb melanin_absorption(const RenderParameters& parameters) {
  const auto concentration = -std::log(std::max(1 - parameters.melanin, 1e-4));
  const auto red = static_cast<float>(concentration * parameters.redness);
  const auto brown = static_cast<float>(concentration) - red;
  return brown * Rgb(0.506F, 0.841F, 1.653F) + red * Rgb(0.343F, 0.733F, 1.924F);
}

}  // namespace

HairShading::HairShading(const RenderParameters& parameters)
    : absorption_(parameters.hair_colour ? absorption_of(linear(*parameters.hair_colour))
                                         : melanin_absorption(parameters)),
      diffuse_(colour_of(absorption_)) {
  const float surfaces = (1 - reflectance) * (1 - reflectance);
  // Most of what goes through is bent to the sides.
  transmitted_ = 0.6F * surfaces * (-absorption_).exp().mean();
}

Rgb HairShading::scattered(const Eigen::Vector3f& tangent, const Eigen::Vector3f& to_light,
                           const Eigen::Vector3f& to_eye, float darker, float width) const {
  const float sine_light = std::clamp(tangent.dot(to_light), -1.0F, 1.0F);
  const float sine_eye = std::clamp(tangent.dot(to_eye), -1.0F, 1.0F);
  const float theta_light = std::asin(sine_light), theta_eye = std::asin(sine_eye);
  const float half = 0.5F * (theta_light + theta_eye);
  const float cosine_light = std::cos(theta_light);
  const float cosine_difference = std::cos(0.5F * (theta_eye - theta_light));

  // The angle between light and eye around the hair; the vectors are those across it.
  const Eigen::Vector3f light_across = to_light - sine_light * tangent;
  const Eigen::Vector3f eye_across = to_eye - sine_eye * tangent;
  const float lengths = std::max(light_across.norm() * eye_across.norm(), 1e-6F);
  const float cosine_phi = std::clamp(light_across.dot(eye_across) / lengths, -1.0F, 1.0F);
  const float phi = std::acos(cosine_phi);
  const float cosine_half_phi = std::cos(0.5F * phi);

  const float reflected = fresnel(cosine_difference * cosine_half_phi);
  const float entered = (1 - reflected) * (1 - reflected);
  const Rgb through = (-darker / std::max(cosine_difference, 0.1F) * absorption_).exp();

  const float r = gaussian(half + tilt, width_r, width) * 0.25F * cosine_half_phi * reflected;
  const Rgb tt = gaussian(half - 0.5F * tilt, width_tt, width) * gaussian(pi - phi, 0.6F, width) *
                 entered * through;
  const Rgb trt = gaussian(half - 1.5F * tilt, width_trt, width) * gaussian(phi, 0.9F, width) *
                  entered * reflected * through * through;
  const float squared = std::max(cosine_difference * cosine_difference, 0.01F);
  const Rgb lobes = (r + tt + trt) / squared;
  const Rgb diffuse = diffuse_ / (pi * pi);
  return cosine_light * (lobes + diffuse);
}

}  // namespace ringlet
