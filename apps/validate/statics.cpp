#include "apps/validate/statics.h"

#include <cmath>

namespace ringlet {

std::unique_ptr<Simulation> run_scene(const Json& scene, const Registry& registry) {
  const Scene read = read_scene(scene, registry, ".");
  auto simulation = std::make_unique<Simulation>(read);
  for (int step = 1; step <= read.run.steps; ++step) {
    const StepReport report = simulation->step();
    if (!report.failure.empty()) throw Error(report.failure);
    if (step == read.run.steps && !report.newton_converged) {
      throw Error("Newton's method has not converged; its last update is " +
                  std::to_string(report.newton_update) + " m");
    }
  }
  return simulation;
}

void set_clamped_edges(Json& scene, int edges, double length) {
  scene["strands"]["vertices"] = edges + 2;
  scene["strands"]["length"] = length * (edges + 1) / edges;
}

double observed_order(double coarse_error, double fine_error) {
  return std::log2(coarse_error / fine_error);
}

}  // namespace ringlet
