#include "apps/bench/baseline/baseline.h"
#include "apps/bench/hairball.h"
#include "collision/modules.h"
#include "core/modules.h"
#include "energies/modules.h"
#include "plugins/modules.h"
#include "solvers/modules.h"
#include "tests/catch.h"

using namespace ringlet;

namespace {

Registry all_plugins() {
  Registry registry;
  register_core(registry);
  register_energies(registry);
  register_solvers(registry);
  register_collision(registry);
  register_plugins(registry);
  return registry;
}

/// A few short wisps, so soft that they sag onto each other, solved to the end.
Json touching_wisps() {
  Json scene = hairball(8);
  scene["strands"].update(
      {{"vertices", 25}, {"roots", {{"type", "hemisphere"}, {"radius", 0.02}}}});
  scene["collision"].erase("colliders");
  scene["collision"]["thickness"] = 4e-3;
  scene["material"].update({{"youngs_modulus", 2000},
                            {"shear_modulus", 2000},
                            {"radius", 0.0035},
                            {"tip_radius", 0.0007}});
  scene["solver"]["tolerance"] = 1e-12;
  scene["integrator"].update({{"newton_iterations", 300}, {"newton_tolerance", 1e-6}});
  return scene;
}

}  // namespace

TEST_CASE("the baseline and the fast step reach the same positions") {
  const Registry registry = with_baseline(all_plugins());
  const auto solver = GENERATE(BaselineSolver::conjugate_gradient, BaselineSolver::ldlt);
  const Json scene = touching_wisps();
  Simulation fast(read_scene(scene, registry, "."));
  Simulation plain(read_scene(baseline_scene(scene, solver), registry, "."));
  const Eigen::Matrix3Xd start = fast.state().positions.matrix();
  for (int step = 0; step < 2; ++step) {
    const StepReport quick = fast.step(), slow = plain.step();
    REQUIRE(quick.failure.empty());
    REQUIRE(slow.failure.empty());
    CHECK(quick.newton_converged);
    CHECK(slow.newton_converged);
    CHECK(quick.contacts.strand_contacts > 0);
    CHECK(quick.contacts.strand_contacts == slow.contacts.strand_contacts);
  }
  const Eigen::Matrix3Xd end = fast.state().positions.matrix();
  CHECK((end - start).colwise().norm().maxCoeff() > 1e-3);
  CHECK((end - plain.state().positions.matrix()).colwise().norm().maxCoeff() < 1e-6);
}

TEST_CASE("a simulation goes on from the state of another one") {
  const Registry registry = all_plugins();
  const Scene scene = read_scene(touching_wisps(), registry, ".");
  Simulation first(scene), second(scene);
  for (int step = 0; step < 3; ++step) first.step();
  second.set_state(first.state());
  first.step();
  second.step();
  CHECK(second.state().time == first.state().time);
  CHECK(second.state().positions.matrix() == first.state().positions.matrix());
  CHECK(second.state().velocities.matrix() == first.state().velocities.matrix());
}
