#include "core/modules.h"
#include "core/simulation.h"
#include "core/verify/verify_energy.h"
#include "energies/modules.h"
#include "solvers/modules.h"
#include "tests/catch.h"

namespace ringlet {
void register_chord_bend(Registry& registry);
}

using namespace ringlet;

TEST_CASE("the README's energy of its own bends a strand back to its rest shape") {
  Registry registry;
  register_core(registry);
  register_energies(registry);
  register_solvers(registry);
  register_chord_bend(registry);

  const Json json = Json::parse(R"({
    "strands": {"type": "explicit", "pinned": 2,
                "strands": [[[0, 0, 0], [0, 0.01, 0], [0.005, 0.02, 0], [0.005, 0.03, 0.005]]]},
    "material": {"radius": 1e-3, "youngs_modulus": 1e7},
    "start": [{"type": "jitter", "amplitude": 0.002, "seed": 3}],
    "energies": [{"type": "stretch"}, {"type": "chord_bend"}]})");
  Simulation simulation(read_scene(json, registry, "."));
  const auto chord = [&](int vertex) {
    const VertexField& x = simulation.state().positions;
    return (x.get(vertex + 2) - x.get(vertex)).norm();
  };
  const Strands& strands = simulation.model().strands;
  const double rest_chord = (strands.rest_position(2) - strands.rest_position(0)).norm();
  REQUIRE(std::abs(chord(0) / rest_chord - 1) > 1e-3);
  StepReport report = simulation.step();
  CHECK(report.energies[1] > 0);
  for (int step = 1; step < 100; ++step) report = simulation.step();
  CHECK(report.failure.empty());
  CHECK(chord(0) == Approx(rest_chord).epsilon(1e-5));
}

TEST_CASE("verify finds nothing wrong with the README's energy") {
  Registry registry;
  register_chord_bend(registry);
  for (const Claim& claim : verify_energy(energy_maker(registry, "chord_bend"), {})) {
    INFO(claim.text << ", " << claim.worst << " in " << claim.worst_state);
    CHECK(claim.holds());
  }
}
