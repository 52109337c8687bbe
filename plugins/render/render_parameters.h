#pragma once

#include <optional>

#include "core/parameters.h"

namespace ringlet {

/// Where a picture is seen from.
struct CameraParameters {
  Eigen::Vector3d direction{0.25, 0.2, 1};
  std::optional<Eigen::Vector3d> position, target, up;
  double field_of_view = 0.5;  // rad

  static Schema<CameraParameters> schema();
};

/// What lights a picture: a key light, whose disc is as wide as its angle, and a sky.
struct LightParameters {
  Eigen::Vector3d direction{0.6, 1, 0.7};
  double angle = 0.06;  // rad
  double key = 1.4;
  double sky = 1;

  static Schema<LightParameters> schema();
};

/// How a picture of a run looks: the entry "render" of a scene.
struct RenderParameters {
  int width = 1280, height = 720;
  int samples = 16;
  int children = 0;
  double child_radius = 4e-5;  // m
  double spread = 1;
  double frizz = 0.5, strays = 0.1;
  double melanin = 0.6, redness = 0.3;
  std::optional<Eigen::Vector3d> hair_colour;
  Eigen::Vector3d collider_colour{0.62, 0.43, 0.33};
  Eigen::Vector3d background{0.83, 0.87, 0.91};
  bool ground = true;
  double exposure = 1;
  CameraParameters camera;
  LightParameters light;

  static Schema<RenderParameters> schema();
};

/// Reads the entry "render". Throws InvalidInput with every problem in it.
RenderParameters read_render_parameters(const Json& json, const Registry& registry);

}  // namespace ringlet
