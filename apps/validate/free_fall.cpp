// What nothing holds: it falls as a point does, and its own forces move and turn it as a whole by
// nothing.

#include <Eigen/Geometry>
#include <cmath>

#include "apps/validate/statics.h"

namespace ringlet {
namespace {

constexpr double gravity = 9.81;  // m/s^2

/// Of all elastic forces at random positions near the rest shape: their sum and their torque, as
/// parts of the sum of their magnitudes (and of arms).
struct Unbalanced {
  double force, torque;
};

Unbalanced unbalanced_forces(const Simulation& simulation) {
  const Model& model = simulation.model();
  VertexField x = simulation.state().positions;
  for (int v = 0; v < model.strands.vertex_count(); ++v) {
    x.add(v, 1e-3 * Eigen::Vector3d(std::sin(7.0 * v), std::cos(5.0 * v), std::sin(3.0 * v + 1)));
  }
  VertexField gradient(model.groups);
  for (int g = 0; g < model.groups.count(); ++g) {
    for (const auto& energy : model.energies) {
      add_at_vertices(*energy, g, x.group(g), {gradient.group(g), {}});
    }
  }
  Eigen::Vector3d force = Eigen::Vector3d::Zero(), torque = Eigen::Vector3d::Zero();
  double forces = 0, torques = 0;
  for (int v = 0; v < model.strands.vertex_count(); ++v) {
    force += gradient.get(v);
    torque += x.get(v).cross(gradient.get(v));
    forces += gradient.get(v).norm();
    torques += x.get(v).norm() * gradient.get(v).norm();
  }
  return {force.norm() / forces, torque.norm() / torques};
}

/// How far a vertex is at most from where it is at rest, both seen from the root, as a part of the
/// length of the strand.
double largest_change_of_shape(const Simulation& simulation) {
  const Strands& strands = simulation.model().strands;
  double largest = 0;
  for (int v = 1; v < strands.vertex_count(); ++v) {
    const Eigen::Vector3d moved =
        simulation.state().positions.get(v) - simulation.state().positions.get(0);
    const Eigen::Vector3d rest = strands.rest_position(v) - strands.rest_position(0);
    largest = std::max(largest, (moved - rest).norm());
  }
  return largest / strands.strand_length(0);
}

}  // namespace

void validate_free_fall(const Registry& registry, const ValidationOptions&,
                        const ValidationOutput& output) {
  const Json scene = validation_scene("free_fall");
  const auto simulation = run_scene(scene, registry);
  const double time = simulation->state().time;
  const Strands& strands = simulation->model().strands;
  const double fallen = strands.rest_position(0).y() - simulation->state().positions.get(0).y();
  output({"free_fall", "way, m", 0.5 * gravity * time * time, fallen, 1e-12});
  output({"free_fall", "speed, m/s", gravity * time, -simulation->state().velocities.get(0).y(),
          1e-12});
  output({"free_fall", "change of shape / length", 0, largest_change_of_shape(*simulation), 1e-12});
  const Unbalanced unbalanced = unbalanced_forces(*simulation);
  output({"free_fall", "sum of inner forces, relative", 0, unbalanced.force, 1e-12});
  output({"free_fall", "sum of inner torques, relative", 0, unbalanced.torque, 1e-12});
}

}  // namespace ringlet
