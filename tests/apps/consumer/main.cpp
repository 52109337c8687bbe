// Uses the installed package: simulates a falling strand and says how far its tip fell.
#include <cstdio>

#include "collision/modules.h"
#include "core/modules.h"
#include "core/simulation.h"
#include "energies/modules.h"
#include "plugins/modules.h"
#include "solvers/modules.h"

int main() {
  ringlet::Registry registry;
  ringlet::register_core(registry);
  ringlet::register_energies(registry);
  ringlet::register_solvers(registry);
  ringlet::register_collision(registry);
  ringlet::register_plugins(registry);
  const auto json = ringlet::Json::parse(R"({
    "strands": {"type": "line", "vertices": 10,
                "roots": {"type": "point", "direction": [1, 0, 0]}},
    "forces": ["gravity"]})");
  ringlet::Simulation simulation(ringlet::read_scene(json, registry, "."));
  const double before = simulation.state().positions.get(9).y();
  for (int step = 0; step < 3; ++step) simulation.step();
  const double fall = before - simulation.state().positions.get(9).y();
  std::printf("the tip fell by %g m\n", fall);
  return fall > 0 ? 0 : 1;
}
