#include "plugins/render/render_parameters.h"

namespace ringlet {
namespace {

/// A direction of any length but zero becomes one of length 1.
void normalise(Eigen::Vector3d& direction, const std::string& pointer, const std::string& name,
               ParseContext& context) {
  const double length = direction.stableNorm();
  if (length > 0 && std::isfinite(length)) {
    direction.stableNormalize();
  } else {
    context.problem(pointer_to(pointer, name), "expected a direction, not length zero");
  }
}

void check_camera(CameraParameters& camera, const std::string& pointer, ParseContext& context) {
  normalise(camera.direction, pointer, "direction", context);
  if (camera.up) normalise(*camera.up, pointer, "up", context);
  if (camera.position.has_value() != camera.target.has_value()) {
    context.problem(pointer,
                    "expected 'position' and 'target', or neither, for a camera that "
                    "frames all by itself");
  } else if (camera.position && *camera.position == *camera.target) {
    context.problem(pointer_to(pointer, "target"), "expected another point than 'position'");
  }
}

}  // namespace

Schema<CameraParameters> CameraParameters::schema() {
  return Schema<CameraParameters>()
      .key("direction", &CameraParameters::direction, "", any_number(),
           "from the strands to a camera that frames all chosen frames by itself")
      .key("position", &CameraParameters::position, "m", any_number(),
           "of the camera; null: where it frames all by itself")
      .key("target", &CameraParameters::target, "m", any_number(),
           "the point in the middle of the picture, if the camera has a position")
      .key("up", &CameraParameters::up, "", any_number(),
           "what is up in the picture, and what the ground is level to; null: against the "
           "scene's gravity, or +y without any")
      .key("field_of_view", &CameraParameters::field_of_view, "rad", between(0.01, 2.5),
           "angle between the lower and the upper edge of the picture")
      .check(check_camera);
}

Schema<LightParameters> LightParameters::schema() {
  return Schema<LightParameters>()
      .key("direction", &LightParameters::direction, "", any_number(), "towards the key light")
      .key("angle", &LightParameters::angle, "rad", between(0, 0.5),
           "radius of the key light's disc; shadows are the softer, the larger it is")
      .key("key", &LightParameters::key, "", at_least(0), "strength of the key light")
      .key("sky", &LightParameters::sky, "", at_least(0), "strength of the light from all around")
      .check([](LightParameters& light, const std::string& pointer, ParseContext& context) {
        normalise(light.direction, pointer, "direction", context);
      });
}

Schema<RenderParameters> RenderParameters::schema() {
  const Range colour = between(0, 1);
  return Schema<RenderParameters>()
      .key("width", &RenderParameters::width, "", between(1, 16384), "of the picture, pixels")
      .key("height", &RenderParameters::height, "", between(1, 16384), "of the picture, pixels")
      .key("samples", &RenderParameters::samples, "", between(1, 4096),
           "rays a pixel; noise falls with their square root")
      .key("children", &RenderParameters::children, "", between(0, 100000),
           "hairs interpolated around each strand; 0: the strands as they are simulated")
      .key("child_radius", &RenderParameters::child_radius, "m", positive(),
           "of an interpolated hair")
      .key("spread", &RenderParameters::spread, "", at_least(0),
           "radius of the bundle of children, in radii of the strand")
      .key("frizz", &RenderParameters::frizz, "", between(0, 1),
           "how far children wander within their bundle; 0: all run parallel")
      .key("strays", &RenderParameters::strays, "", between(0, 1),
           "the part of the children that leave their bundle, for up to four times its radius")
      .key("melanin", &RenderParameters::melanin, "", between(0, 1),
           "0: white, 0.3: blond, 0.6: brown, 1: black hair")
      .key("redness", &RenderParameters::redness, "", between(0, 1),
           "the part of the melanin that is red")
      .key("hair_colour", &RenderParameters::hair_colour, "", colour,
           "instead of melanin: what many hairs look like, sRGB")
      .key("collider_colour", &RenderParameters::collider_colour, "", colour, "sRGB")
      .key("background", &RenderParameters::background, "", colour, "and of the ground, sRGB")
      .key("ground", &RenderParameters::ground, "", any_number(),
           "a level plane below all else, if no collider is a plane")
      .key("exposure", &RenderParameters::exposure, "", positive(), "factor of all light")
      .key("camera", &RenderParameters::camera, "", any_number(), "where it is seen from")
      .key("light", &RenderParameters::light, "", any_number(), "what lights it");
}

RenderParameters read_render_parameters(const Json& json, const Registry& registry) {
  std::vector<Problem> problems;
  ParseContext context{registry, ".", {}, problems};
  RenderParameters parameters;
  RenderParameters::schema().read(json, "/render", context, parameters);
  if (!problems.empty()) throw InvalidInput(std::move(problems));
  return parameters;
}

}  // namespace ringlet
