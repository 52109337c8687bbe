// Coulomb's incline: a body on a slope sticks if tan(alpha) <= mu, else it slides with the
// acceleration g (sin(alpha) - mu cos(alpha)).

#include "tests/catch.h"
#include "tests/collision/physics/simulate.h"

using namespace ringlet;

namespace {

constexpr double g = 9.81, mu = 0.4;

/// A strand of two vertices across a plane, in equilibrium with its push; gravity is tilted.
Simulation slope(double alpha) {
  const Json gravity = {g * std::sin(alpha), -g * std::cos(alpha), 0};
  return simulate(
      R"({"strands": {"type": "explicit", "pinned": 0, "strands": [[[0, 5e-4, 0], [0, 5e-4, 0.01]]]},
    "energies": ["stretch"], "forces": [{"type": "gravity", "acceleration": )" +
      gravity.dump() + R"(}],
    "collision": {"type": "fcl", "stiffness": 0.2, "collider_friction": )" +
      std::to_string(mu) + R"(, "colliders": [{"type": "plane", "normal": [0, 1, 0]}]},
    "solver": "cholesky",
    "integrator": {"type": "bdf1", "dt": 0.001, "newton_iterations": 50, "newton_tolerance": 1e-7}})");
}

double speed_after(Simulation& simulation, int steps) {
  for (int i = 0; i < steps; ++i) REQUIRE(simulation.step().failure.empty());
  return simulation.state().velocities.get(0).x();
}

}  // namespace

TEST_CASE("on an incline a strand sticks up to the angle of friction") {
  Simulation simulation = slope(std::atan(0.97 * mu));
  CHECK(std::abs(speed_after(simulation, 300)) < 1e-3);  // the sticking speed
}

TEST_CASE("on a steeper incline it slides with the acceleration of Coulomb's law") {
  const double alpha = GENERATE(std::atan(1.1 * mu), std::atan(2 * mu), 1.2);
  Simulation simulation = slope(alpha);
  const double before = speed_after(simulation, 100), after = speed_after(simulation, 300);
  const double expected = g * (std::sin(alpha) - mu * std::cos(alpha));
  CHECK((after - before) / 0.3 == Approx(expected).epsilon(0.03));
}
