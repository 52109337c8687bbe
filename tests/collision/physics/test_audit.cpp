// The audit of a step sees what passes through each other, and what lies inside of a collider.

#include "tests/catch.h"
#include "tests/simulate.h"

using namespace ringlet;

namespace {

/// A strand that falls on one that is held at both ends, or past it; k and the response as given.
Simulation falling_strand(const std::string& response, double stiffness, double speed_of_fall) {
  const Json gravity = {0, -speed_of_fall, 0};
  return simulate(R"({"strands": [
      {"type": "explicit", "pinned": 2, "strands": [[[-0.05, 0, 0], [0.05, 0, 0]]]},
      {"type": "explicit", "pinned": 0, "strands": [[[0, 0.01, -0.05], [0, 0.01, 0.05]]]}],
    "energies": ["stretch"],
    "forces": [{"type": "gravity", "acceleration": )" +
                  gravity.dump() + R"(}],
    "collision": {"type": "fcl", "stiffness": )" +
                  std::to_string(stiffness) + R"(, "audit": true, "response": ")" + response +
                  R"("},
    "solver": "cholesky", "integrator": {"type": "bdf1", "dt": 0.01, "newton_iterations": 50}})");
}

double crossings_of(Simulation& simulation, int steps) {
  double crossings = 0;
  for (int step = 0; step < steps; ++step) {
    const StepReport report = simulation.step();
    REQUIRE(report.failure.empty());
    crossings += report.contacts.crossings;
  }
  return crossings;
}

}  // namespace

TEST_CASE("the audit counts strands that pass through each other, once") {
  Simulation soft = falling_strand("penalty", 1e-6, 9.81);
  CHECK(crossings_of(soft, 20) == 1);
  Simulation stiff = falling_strand("penalty", 10, 0.5);
  CHECK(crossings_of(stiff, 20) == 0);
}

TEST_CASE("the audit tells how deep a vertex lies inside of a collider") {
  Simulation simulation = simulate(R"({
    "strands": {"type": "explicit", "pinned": 0, "strands": [[[0, -0.002, 0], [0.1, 0.1, 0]]]},
    "energies": [], "collision": {"type": "fcl", "stiffness": 0, "audit": true,
      "colliders": [{"type": "plane", "normal": [0, 1, 0]}]}})");
  const StepReport report = simulation.step();
  CHECK(report.contacts.depth == Approx(0.002));
  CHECK(report.contacts.crossings == 0);
}

TEST_CASE("without an audit its figures are not numbers") {
  Simulation simulation = simulate(R"({
    "strands": {"type": "explicit", "strands": [[[0, 0, 0], [0.1, 0.1, 0]]]},
    "collision": {"type": "fcl"}})");
  const StepReport report = simulation.step();
  CHECK(std::isnan(report.contacts.crossings));
  CHECK(std::isnan(report.contacts.depth));
}

TEST_CASE("a scene without collision has no stage and spends no time on it") {
  Simulation simulation = simulate(R"({
    "strands": {"type": "explicit", "strands": [[[0, 0, 0], [0.1, 0.1, 0]]]},
    "forces": [{"type": "gravity"}]})");
  CHECK(simulation.model().collision == nullptr);
  const StageSeconds seconds = simulation.step().seconds;
  CHECK(seconds.detect == 0);
  CHECK(seconds.couple == 0);
}

TEST_CASE("nothing passes a barrier, however soft it is and whatever the response of a spring") {
  Simulation soft = falling_strand("barrier", 1e-6, 9.81);
  CHECK(crossings_of(soft, 40) == 0);
  CHECK(soft.state().positions.get(2).y() > 0);
}

TEST_CASE("no vertex enters a collider that moves, if a barrier keeps it out") {
  const bool with_barrier = GENERATE(true, false);
  Simulation simulation = simulate(R"({
    "motions": {"go": [{"type": "keyframes", "times": [0, 1], "translations": [[0, 0, 0], [0, 0, 2]]}]},
    "strands": {"type": "explicit", "pinned": 0,
                "strands": [[[-0.02, 0, 0], [-0.01, 0, 0], [0, 0, 0], [0.01, 0, 0], [0.02, 0, 0]]]},
    "energies": ["stretch"],
    "collision": {"type": "fcl", "stiffness": 1e-3, "audit": true, "response": ")" +
                                   std::string(with_barrier ? "barrier" : "penalty") + R"(",
      "colliders": [{"type": "sphere", "radius": 0.03, "centre": [0, 0, -0.032], "motion": "go"}]},
    "solver": "cholesky", "integrator": {"type": "bdf1", "dt": 0.0002, "newton_iterations": 50}})");
  double deepest = 0;
  for (int step = 0; step < 50; ++step) {
    const StepReport report = simulation.step();
    CAPTURE(step, report.failure);
    REQUIRE(report.failure.empty());
    deepest = std::max(deepest, report.contacts.depth);
  }
  CHECK((deepest == 0) == with_barrier);
}

TEST_CASE("a step in which pins alone would drag strands through each other fails, and says so") {
  Simulation simulation = simulate(R"({
    "motions": {"go": [{"type": "keyframes", "times": [0, 1], "translations": [[0, 0, 0], [0, 0, 1]]}]},
    "strands": [
      {"type": "explicit", "pinned": 1, "motion": "go", "strands": [[[-0.05, 0, 0], [0.05, 0, 0], [0.1, 0, 0]]]},
      {"type": "explicit", "pinned": 2, "strands": [[[0, -0.05, 0.01], [0, 0.05, 0.01], [0, 0.1, 0.01]]]}],
    "collision": {"type": "fcl", "response": "barrier"},
    "integrator": {"type": "bdf1", "dt": 0.05}})");
  CHECK(simulation.step().failure.find("pass through each other") != std::string::npos);
}
