#include "plugins/render/lighting.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "plugins/render/colour.h"
#include "plugins/render/hash.h"

namespace ringlet {
namespace {

/// Parts of the light on a white surface that faces the key light and the sky.
constexpr float key_part = 0.7F, sky_part = 0.3F;

/// The sky is so wide that highlights blur, rad.
constexpr float sky_width = 0.6F;

struct Sides {
  Eigen::Vector3f first, second;
};

Sides sides_of(const Eigen::Vector3f& direction) {
  int axis = 0;
  direction.cwiseAbs().minCoeff(&axis);
  const Eigen::Vector3f first = direction.cross(Eigen::Vector3f::Unit(axis)).normalized();
  return {first, direction.cross(first)};
}

/// A point of the unit disc for a point of the unit square; areas keep their ratio.
Eigen::Vector2f in_disc(float u, float v) {
  const float distance = std::sqrt(u), angle = 2 * pi * v;
  return {distance * std::cos(angle), distance * std::sin(angle)};
}

Eigen::Vector3f on_sphere(float u, float v) {
  const float z = 1 - 2 * u, radius = std::sqrt(std::max(0.0F, 1 - z * z)), angle = 2 * pi * v;
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

/// As often towards a direction as a matt surface reflects it.
Eigen::Vector3f above(const Eigen::Vector3f& normal, float u, float v) {
  const Eigen::Vector2f disc = in_disc(u, v);
  const Sides sides = sides_of(normal);
  const float height = std::sqrt(std::max(0.0F, 1 - disc.squaredNorm()));
  return disc.x() * sides.first + disc.y() * sides.second + height * normal;
}

/// Rays from a surface begin a little above it.
Ray ray_from(const Ray& ray, const Hit& hit, const Eigen::Vector3f& direction) {
  const float away = 1e-4F * hit.distance;
  return {ray.origin + hit.distance * ray.direction + away * hit.across, direction};
}

}  // namespace

Lighting::Lighting(const TracedScene& scene, const RenderParameters& parameters,
                   const Eigen::Vector3d& up)
    : scene_(scene),
      hair_(parameters),
      up_(up.cast<float>()),
      key_direction_(parameters.light.direction.cast<float>()),
      key_radius_(static_cast<float>(std::tan(parameters.light.angle))),
      key_(static_cast<float>(parameters.light.key) * key_part * pi),
      sky_(static_cast<float>(parameters.light.sky) * sky_part),
      background_(linear(parameters.background)),
      collider_(linear(parameters.collider_colour)) {}

Eigen::Vector3f Lighting::towards_key(const PixelSample& sample) const {
  const Eigen::Vector2f disc = key_radius_ * in_disc(sample(on_light), sample(on_light + 1));
  const Sides sides = sides_of(key_direction_);
  return (key_direction_ + disc.x() * sides.first + disc.y() * sides.second).normalized();
}

/// Brighter above; from below comes what the ground reflects.
float Lighting::sky(const Eigen::Vector3f& direction) const {
  const float height = direction.dot(up_);
  return sky_ * (height > 0 ? 0.8F + 0.4F * height : 0.8F + 0.5F * height);
}

Rgb Lighting::from_hair(const Ray& ray, const Hit& hit, const PixelSample& sample) const {
  const Eigen::Vector3f point = ray.origin + hit.distance * ray.direction;
  const Eigen::Vector3f to_eye = -ray.direction;
  const float darker = 0.75F + 0.5F * hashed_uniform(hit.hair, 17);
  // The hair itself does not shade what was computed for a whole hair.
  const float inside = 2.1F * hit.radius;
  Rgb light = Rgb::Zero();
  const Eigen::Vector3f key = towards_key(sample);
  if (!scene_.is_shadowed({point, key, inside}, sample.seed)) {
    light += key_ * hair_.scattered(hit.across, key, to_eye, darker, key_radius_);
  }
  const Eigen::Vector3f around = on_sphere(sample(in_sky), sample(in_sky + 1));
  if (!scene_.is_shadowed({point, around, inside}, sample.seed + 1)) {
    light += 4 * pi * sky(around) * hair_.scattered(hit.across, around, to_eye, darker, sky_width);
  }
  return light;
}

Rgb Lighting::from_surface(const Ray& ray, const Hit& hit, const PixelSample& sample) const {
  float light = 0;
  const Eigen::Vector3f key = towards_key(sample);
  const float facing = hit.across.dot(key);
  if (facing > 0 && !scene_.is_shadowed(ray_from(ray, hit, key), sample.seed)) {
    light += key_ / pi * facing;
  }
  const Eigen::Vector3f around = above(hit.across, sample(in_sky), sample(in_sky + 1));
  if (!scene_.is_shadowed(ray_from(ray, hit, around), sample.seed + 1)) light += sky(around);
  return light * collider_;
}

// A level plane without shadows looks like the background, so that there is no horizon.
Rgb Lighting::from_plane(const Ray& ray, const Hit& hit, const PixelSample& sample) const {
  const float level = std::max(key_direction_.dot(up_), 0.1F);
  const float full = key_ / pi * level + sky_;
  if (!(full > 0)) return Rgb::Zero();
  float light = 0;
  const Eigen::Vector3f key = towards_key(sample);
  if (!scene_.is_shadowed(ray_from(ray, hit, key), sample.seed)) {
    light += key_ / pi * std::max(key_direction_.dot(hit.across), 0.0F);
  }
  const Eigen::Vector3f around = above(hit.across, sample(in_sky), sample(in_sky + 1));
  if (!scene_.is_shadowed(ray_from(ray, hit, around), sample.seed + 1)) light += sky_;
  return light / full * background_;
}

Rgb Lighting::arriving(const Ray& ray, const PixelSample& sample) const {
  const std::optional<Hit> hit = scene_.nearest(ray);
  if (!hit) return background_;
  switch (hit->kind) {
    case Hit::Kind::hair:
      return from_hair(ray, *hit, sample);
    case Hit::Kind::collider:
      return from_surface(ray, *hit, sample);
    case Hit::Kind::plane:
      return from_plane(ray, *hit, sample);
  }
  return background_;
}

}  // namespace ringlet
