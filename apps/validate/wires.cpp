// Wires without bending stiffness, in equilibrium.

#include <array>
#include <cmath>
#include <numbers>

#include "apps/validate/statics.h"

namespace ringlet {
namespace {

constexpr double gravity = 9.81;  // m/s^2

double section_of(const Json& scene) {
  const double radius = scene["material"]["radius"];
  return std::numbers::pi * radius * radius;
}

/// By which part of its length a wire that hangs from the origin is longer than at rest.
double strain_of(const Json& scene, const Registry& registry) {
  const auto simulation = run_scene(scene, registry);
  const Strands& strands = simulation->model().strands;
  double stretched = 0;
  for (int v = 0; v + 1 < strands.vertex_count(); ++v) {
    const VertexField& x = simulation->state().positions;
    stretched += (x.get(v + 1) - x.get(v)).norm() - strands.rest_length(v);
  }
  return stretched / strands.strand_length(0);
}

/// An arc of a circle below the chord from 0 to (1, 0, 0), as a polyline of equal edges whose
/// lengths add up to `length`.
std::vector<Eigen::Vector3d> hanging_arc(double length, int edges) {
  const double edge = length / edges;
  // With the angle alpha of each edge at the centre: edge = 2 R sin(alpha/2), and the chord is
  // 1 = 2 R sin(edges alpha / 2).
  double low = 0, high = 2 * std::numbers::pi / edges;
  for (int i = 0; i < 200; ++i) {
    const double alpha = 0.5 * (low + high);
    const double chord = edge / std::sin(alpha / 2) * std::sin(edges * alpha / 2);
    (chord > 1 ? low : high) = alpha;
  }
  const double alpha = 0.5 * (low + high), radius = edge / (2 * std::sin(alpha / 2));
  const double depth = radius * std::cos(edges * alpha / 2);  // of the chord below the centre
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i <= edges; ++i) {
    const double angle = alpha * (i - 0.5 * edges);
    points.push_back({0.5 + radius * std::sin(angle), depth - radius * std::cos(angle), 0});
  }
  points.front() = {0, 0, 0};
  points.back() = {1, 0, 0};
  return points;
}

double sag_of_chain(double length, int edges, const Registry& registry) {
  Json scene = validation_scene("catenary");
  Json& strand = scene["strands"]["strands"][0] = Json::array();
  for (const Eigen::Vector3d& p : hanging_arc(length, edges)) strand.push_back({p.x(), p.y(), 0});
  const auto simulation = run_scene(scene, registry);
  return -simulation->state().positions.get(edges / 2).y();
}

}  // namespace

void validate_wire(const Registry& registry, const ValidationOptions&,
                   const ValidationOutput& output) {
  Json scene = validation_scene("hanging_wire");
  const double modulus = scene["material"]["youngs_modulus"], section = section_of(scene);
  const double load = 3;  // N
  scene["forces"] = {{{"type", "point_force"}, {"force", {0, -load, 0}}}};
  output({"wire", "strain under a load", load / (modulus * section), strain_of(scene, registry),
          1e-6});
  scene["forces"] = {"gravity"};
  const double density = scene["material"]["density"];
  const double length = scene["strands"]["length"];
  output({"wire", "strain under its own weight", density * gravity * length / (2 * modulus),
          strain_of(scene, registry), 1e-6});
}

void validate_catenary(const Registry& registry, const ValidationOptions&,
                       const ValidationOutput& output) {
  struct Chain {
    double length, sag;
  };
  for (const auto& [length, sag] : {Chain{2, 0.7963884}, Chain{1.2, 0.2923438}}) {
    const double measured = sag_of_chain(length, 100, registry);
    const double coarse = sag_of_chain(length, 10, registry),
                 fine = sag_of_chain(length, 20, registry);
    output({"catenary", "sag / span, length " + Json(length).dump(), sag, measured, 5e-3,
            observed_order(std::abs(coarse - sag), std::abs(fine - sag)), 1.8});
  }
}

}  // namespace ringlet
