// Once a step has taken its memory it asks for no more: what is left are a few short lists a step,
// however many strands there are and whatever Newton's method does.

#include <tbb/global_control.h>

#include "tests/apps/counted_allocations.h"
#include "tests/catch.h"
#include "tests/simulate.h"

using namespace ringlet;

namespace {

// The list of energies in the report, the sums of the kinetic energy, the motions of pins, and the
// points from which the collision stage finds the motion of all.
constexpr long short_lists = 8;

/// The fewest allocations of a step once everything has come to rest: in the others a list may
/// grow.
long allocations_of_a_step(Json scene, const Json& collision) {
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, 1);
  scene["collision"] = collision;
  Simulation simulation = simulate(scene.dump());
  long fewest = std::numeric_limits<long>::max();
  for (int step = 0; step < 40; ++step) {
    const long before = allocation_count();
    const StepReport report = simulation.step();
    const long during = allocation_count() - before;
    REQUIRE(report.newton_iterations == scene["integrator"]["newton_iterations"]);
    if (!collision.is_null()) REQUIRE(report.contacts.strand_contacts > 10);
    if (step >= 20) fewest = std::min(fewest, during);
  }
  return fewest;
}

Json curls(int count, int newton_iterations) {
  Json scene = Json::parse(R"({
    "strands": {"type": "helix", "vertices": 40, "roots": {"type": "hemisphere", "radius": 0.02}},
    "forces": [{"type": "gravity"}],
    "integrator": {"type": "bdf1", "newton_tolerance": 0}})");
  scene["strands"]["count"] = count;
  scene["integrator"]["newton_iterations"] = newton_iterations;
  return scene;
}

}  // namespace

TEST_CASE("the allocations of this program are counted") {
  const long before = allocation_count();
  const std::vector<double> some(10);
  CHECK(allocation_count() == before + 1);
}

TEST_CASE("a step without contacts allocates no more than a few short lists") {
  for (const int count : {10, 80}) {
    for (const int iterations : {1, 4}) {
      CHECK(allocations_of_a_step(curls(count, iterations), nullptr) <= short_lists);
    }
  }
}

TEST_CASE("a step with contacts allocates no more than a few short lists") {
  for (const std::string detect : {"margin", "step"}) {
    const Json collision{{"type", "fcl"},
                         {"push_at_rest", true},
                         {"detect", detect},
                         {"colliders", {{{"type", "sphere"}, {"radius", 0.021}}}}};
    CHECK(allocations_of_a_step(curls(80, 3), collision) <= short_lists);
  }
}
