#pragma once

#include "collision/modules.h"
#include "core/modules.h"
#include "core/scene.h"
#include "core/simulation.h"
#include "energies/modules.h"
#include "solvers/modules.h"

namespace ringlet {

/// A scene with all plugins but the writers. Throws InvalidInput.
inline Simulation simulate(const std::string& scene) {
  Registry registry;
  register_core(registry);
  register_energies(registry);
  register_solvers(registry);
  register_collision(registry);
  return Simulation(read_scene(Json::parse(scene), registry, "/"));
}

}  // namespace ringlet
