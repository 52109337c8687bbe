#include "apps/bench/baseline/baseline.h"

#include "apps/bench/baseline/eigen_solvers.h"

namespace ringlet {

Registry with_baseline(Registry registry) {
  register_eigen_cg(registry);
  register_eigen_ldlt(registry);
  return registry;
}

Json baseline_scene(Json scene, BaselineSolver solver) {
  for (Json& energy : scene["energies"]) {
    if (energy.is_string()) energy = {{"type", energy}};
    energy.update({{"filter", "clamp"}, {"evaluation", "scalar"}});
  }
  if (solver == BaselineSolver::ldlt) {
    scene["solver"] = "eigen_ldlt";
  } else {
    const Json given = scene["solver"];
    scene["solver"] = {{"type", "eigen_cg"}};
    if (given.contains("tolerance")) scene["solver"]["tolerance"] = given["tolerance"];
  }
  return scene;
}

}  // namespace ringlet
