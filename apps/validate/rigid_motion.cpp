// What moves as a whole keeps its energy, and its forces turn with it.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "apps/validate/statics.h"

namespace ringlet {
namespace {

struct Elastic {
  double value = 0;           // J
  Eigen::Matrix3Xd gradient;  // N
};

Elastic elastic_at(const Model& model, const Eigen::Matrix3Xd& positions) {
  VertexField x(model.groups), gradient(model.groups);
  for (int v = 0; v < positions.cols(); ++v) x.set(v, positions.col(v));
  Elastic elastic;
  for (int g = 0; g < model.groups.count(); ++g) {
    for (const auto& energy : model.energies) {
      elastic.value += add_at_vertices(*energy, g, x.group(g), {gradient.group(g), {}});
    }
  }
  elastic.gradient = gradient.matrix();
  return elastic;
}

}  // namespace

void validate_rigid_motion(const Registry& registry, const ValidationOptions&,
                           const ValidationOutput& output) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(0.6, -0.48, 0.64)).toRotationMatrix();
  const Eigen::Vector3d shift(0.3, -0.2, 0.1);
  for (const std::string& name : registry.of<Energy>().names()) {
    Json scene = validation_scene("free_fall");
    scene["energies"] = {name};
    const Simulation simulation(read_scene(scene, registry, "."));
    Eigen::Matrix3Xd x = simulation.state().positions.matrix();
    for (int v = 0; v < x.cols(); ++v) {
      x.col(v) += 1e-3 * Eigen::Vector3d(std::sin(7.0 * v), std::cos(5.0 * v), std::sin(3.0 * v));
    }
    const Elastic before = elastic_at(simulation.model(), x);
    const Elastic after = elastic_at(simulation.model(), (turn * x).colwise() + shift);
    const double of_value = std::abs(after.value / before.value - 1);
    const double of_forces =
        (after.gradient - turn * before.gradient).norm() / before.gradient.norm();
    output({"rigid_motion", "change of energy and turned forces, " + name + ", relative", 0,
            std::max(of_value, of_forces), 1e-12});
  }
}

}  // namespace ringlet
