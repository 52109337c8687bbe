#include "tests/catch.h"
#include "tests/solvers/integrators/lively.h"

using namespace ringlet;

TEST_CASE("one quasistatic step ends in the equilibrium of a hanging strand") {
  const auto model = make_model({6, 4}, true);
  const double stiffness = 2;
  const Eigen::Vector3d gravity(0.3, -0.2, -9.81);
  add_energy(*model, std::make_unique<Springs>(stiffness));
  add_force(*model, std::make_unique<Weight>(gravity));
  const auto integrator = make_integrator("quasistatic", *model);
  State state = thrown_state(*model);
  const StepReport report = integrator->step(*model, state, 1);
  REQUIRE(report.failure.empty());
  CHECK(report.newton_converged);
  double carried = 0;
  for (int v = 5; v > 0; --v) {
    carried += model->strands.mass(v);
    const Eigen::Vector3d rest =
        model->strands.rest_position(v) - model->strands.rest_position(v - 1);
    const Eigen::Vector3d edge = state.positions.get(v) - state.positions.get(v - 1);
    CHECK((edge - rest - carried / stiffness * gravity).norm() < 1e-12);
  }
}

TEST_CASE("resistance lets strands without inertia creep") {
  // One free vertex at the end of a spring: k (x - d) = -c m dx/dt, x falls as exp(-k t / (c m)).
  const auto model = make_model({2}, true);
  const double m = model->strands.mass(1), c = 3, k = 1.5 * m, dt = 0.1;
  add_energy(*model, std::make_unique<Springs>(k));
  add_force(*model, std::make_unique<Resistance>(c));
  const auto integrator = make_integrator("quasistatic", *model);
  State state = rest_state(*model);
  const Eigen::Vector3d rest = state.positions.get(1);
  state.positions.set(1, rest + Eigen::Vector3d(0.2, 0, 0.1));
  for (int n = 1; n <= 5; ++n) {
    REQUIRE(integrator->step(*model, state, dt).failure.empty());
    const double left = std::pow(1 / (1 + k * dt / (c * m)), n);
    CHECK((state.positions.get(1) - rest).isApprox(left * Eigen::Vector3d(0.2, 0, 0.1), 1e-9));
  }
}

TEST_CASE("strands that nothing holds stay where they are in equilibrium") {
  const auto model = make_model({5, 3}, false);
  add_energy(*model, std::make_unique<Springs>(2));
  const auto integrator = make_integrator("quasistatic", *model);
  State state = rest_state(*model);
  state.positions.add(2, {0.1, 0, 0});
  const StepReport report = integrator->step(*model, state, 1);
  REQUIRE(report.failure.empty());
  for (int v = 0; v + 1 < 5; ++v) {
    const Eigen::Vector3d rest =
        model->strands.rest_position(v + 1) - model->strands.rest_position(v);
    CHECK((state.positions.get(v + 1) - state.positions.get(v) - rest).norm() < 1e-6);
  }
}
