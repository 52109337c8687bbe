// A close helix of wire as a spring: with the wire's length l, radius R of the helix and its pitch
// angle alpha, B = EI and C = GJ, its own weight w l makes it longer by
//
//     sag = (w l^2 / 2) R^2 (cos^2 alpha / C + sin^2 alpha / B)
//
// to first order (Love, A Treatise on the Mathematical Theory of Elasticity, section 271), that is
// by w l^2 / 2 divided by the stiffness of a unit of length.

#include <cmath>

#include "apps/validate/statics.h"

namespace ringlet {
namespace {

/// A helix of a scene, and what bends and twists in it.
struct Spring {
  double radius, pitch;   // of the helix, m
  double bending, twist;  // B, C, N m^2
  double weight;          // w, N/m

  double sine() const { return pitch / std::hypot(pitch, 2 * pi * radius); }
  double wire_of(double turns) const { return turns * std::hypot(pitch, 2 * pi * radius); }
  /// R^2 (cos^2/C + sin^2/B), 1/N: of a wire of length l, the stiffness is 1 / (l compliance).
  double compliance() const {
    const double s = sine();
    return radius * radius * ((1 - s * s) / twist + s * s / bending);
  }
};

Spring describe(const Json& scene) {
  const Json& material = scene["material"];
  const double r = material["radius"], modulus = material["youngs_modulus"];
  const double shear = modulus / (2 * (1 + material["poisson_ratio"].get<double>()));
  const double section = pi * r * r, inertia = pi * std::pow(r, 4) / 4;
  const double acceleration = -scene["forces"][0]["acceleration"][1].get<double>();
  return {scene["strands"]["curl_radius"], scene["strands"]["pitch"], modulus * inertia,
          shear * 2 * inertia, material["density"].get<double>() * section * acceleration};
}

/// How much longer the helix of a scene gets, as a part of what the formula says.
double measured_over_expected(int segments, int turns, const Registry& registry) {
  Json scene = validation_scene("spring");
  scene["strands"]["segments_per_turn"] = segments;
  scene["strands"]["vertices"] = segments * turns + 1;
  const Spring spring = describe(scene);
  const auto simulation = run_scene(scene, registry);
  const int tip = simulation->model().strands.vertex_count() - 1;
  const double sag = simulation->model().strands.rest_position(tip).y() -
                     simulation->state().positions.get(tip).y();
  const double wire = spring.wire_of(turns);
  return sag / (0.5 * spring.weight * wire * wire * spring.compliance());
}

/// The pitch of the uppermost coil of so many under their own weight, as a multiple of that at
/// rest.
double pitch_of_root_coil(int coils, const Registry& registry) {
  constexpr int segments = 40;
  Json scene = validation_scene("spring");
  scene["strands"]["vertices"] = segments * coils + 1;
  scene["forces"][0]["acceleration"] = {0, -9.81, 0};
  scene["integrator"]["newton_iterations"] = 2000;
  const auto simulation = run_scene(scene, registry);
  const int clamp = scene["strands"]["pinned"].get<int>() - 1;
  const VertexField& x = simulation->state().positions;
  return (x.get(clamp).y() - x.get(clamp + segments).y()) / scene["strands"]["pitch"].get<double>();
}

}  // namespace

void validate_spring(const Registry& registry, const ValidationOptions& options,
                     const ValidationOutput& output) {
  const int turns = 10;
  for (const int segments : {5, 10, 20, 40, 80}) {
    if (options.quick && segments != 40) continue;
    // What a coarse helix gives is told, not asked.
    const double tolerance = segments >= 40 ? 0.02 : 1;
    output({"spring", "sag / exact, " + std::to_string(segments) + " vertices a turn", 1,
            measured_over_expected(segments, turns, registry), tolerance});
  }
  // The fibre of the scene is of type 4C.
  Spring fibre = describe(validation_scene("spring"));
  const double exact = 1 / (fibre.wire_of(1) * fibre.compliance());
  output({"spring", "stiffness of one coil of type 4C, N/m", 3.84e-3,
          exact / measured_over_expected(40, turns, registry), 0.05});
  // 12 are about as many as double it.
  output({"spring", "pitch of the root coil of type 4C under 12 coils / at rest", 2,
          pitch_of_root_coil(12, registry), 0.1});
}

}  // namespace ringlet
