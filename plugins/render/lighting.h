#pragma once

#include "plugins/render/hair_shading.h"
#include "plugins/render/render_parameters.h"
#include "plugins/render/sample_pattern.h"
#include "plugins/render/traced_scene.h"

namespace ringlet {

/// A sample of a pixel: where its random numbers come from.
struct PixelSample {
  const SamplePattern& pattern;
  int number;
  unsigned seed;  ///< decides by chance which hairs light goes through

  float operator()(int dimension) const { return pattern(number, dimension); }
};

/// The light that comes along rays. A surface that is white and faces the key light has radiance 1.
class Lighting {
 public:
  /// `up` has length 1. The scene must outlive this.
  Lighting(const TracedScene& scene, const RenderParameters& parameters, const Eigen::Vector3d& up);

  /// Along a ray from the camera, by one sample of each light.
  Rgb arriving(const Ray& ray, const PixelSample& sample) const;

 private:
  Rgb from_hair(const Ray& ray, const Hit& hit, const PixelSample& sample) const;
  Rgb from_surface(const Ray& ray, const Hit& hit, const PixelSample& sample) const;
  Rgb from_plane(const Ray& ray, const Hit& hit, const PixelSample& sample) const;
  Eigen::Vector3f towards_key(const PixelSample& sample) const;
  float sky(const Eigen::Vector3f& direction) const;

  const TracedScene& scene_;
  HairShading hair_;
  Eigen::Vector3f up_, key_direction_;
  float key_radius_;  // tangent of the key light's angle
  float key_, sky_;   // irradiance of the key light, radiance of the sky
  Rgb background_, collider_;
};

}  // namespace ringlet
