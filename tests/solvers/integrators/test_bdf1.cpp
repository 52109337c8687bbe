#include <tbb/global_control.h>

#include <limits>

#include "core/kinetic_energy.h"
#include "tests/catch.h"
#include "tests/solvers/test_model.h"

using namespace ringlet;

namespace {

const Eigen::Vector3d gravity(0.3, -0.2, -9.81);
constexpr double frame = 1.0 / 30;  // s

const std::vector<int> lengths{4, 7, 3, 5, 6, 2, 8, 9, 5, 4};

Eigen::Vector3d momentum(const Model& model, const State& state) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int v = 0; v < model.strands.vertex_count(); ++v) {
    sum += model.strands.mass(v) * state.velocities.get(v);
  }
  return sum;
}

double total_mass(const Model& model) {
  double sum = 0;
  for (int v = 0; v < model.strands.vertex_count(); ++v) sum += model.strands.mass(v);
  return sum;
}

void shake(const Model& model, State& state) {
  for (int v = 0; v < model.strands.vertex_count(); ++v) {
    state.velocities.set(v, 0.1 * Eigen::Vector3d(std::sin(v), std::cos(2 * v), std::sin(3 * v)));
  }
}

}  // namespace

TEST_CASE("free fall is that of implicit Euler, to rounding") {
  const auto model = make_model(lengths, false);
  add_energy(*model, std::make_unique<Springs>(5));
  add_force(*model, std::make_unique<Weight>(gravity));
  const auto integrator = make_integrator({{"type", "bdf1"}, {"dt", frame}}, *model);
  CHECK(integrator->time_step() == frame);
  State state = rest_state(*model);
  const Eigen::Matrix3Xd start = state.positions.matrix();
  for (int n = 1; n <= 20; ++n) {
    const StepReport report = integrator->step(*model, state, frame);
    REQUIRE(report.failure.empty());
    CHECK(report.newton_converged);
    const Eigen::Vector3d fallen = 0.5 * n * (n + 1) * frame * frame * gravity;
    CHECK((state.positions.matrix() - (start.colwise() + fallen)).cwiseAbs().maxCoeff() < 1e-12);
    CHECK(state.velocities.get(3).isApprox(n * frame * gravity, 1e-12));
    CHECK(report.kinetic_energy ==
          Approx(0.5 * total_mass(*model) * (n * frame * gravity).squaredNorm()));
    CHECK(state.time == Approx(n * frame));
  }
}

TEST_CASE("internal energies keep the momentum, and damping only takes energy away") {
  const auto model = make_model(lengths, false);
  add_energy(*model, std::make_unique<Springs>(5));
  const auto integrator = make_integrator({{"type", "bdf1"}, {"newton_tolerance", 1e-10}}, *model);
  State state = rest_state(*model);
  shake(*model, state);
  const Eigen::Vector3d start = momentum(*model, state);
  REQUIRE(start.norm() > 1e-8);
  const double start_energy = kinetic_energy(*model, state.velocities);
  double energy = start_energy;
  for (int n = 0; n < 30; ++n) {
    const StepReport report = integrator->step(*model, state, frame);
    REQUIRE(report.failure.empty());
    CHECK((momentum(*model, state) - start).norm() < 1e-10 * start.norm());
    // But for what the Newton tolerance leaves open.
    CHECK(report.kinetic_energy + report.energies[0] <= (1 + 1e-9) * energy);
    energy = report.kinetic_energy + report.energies[0];
  }
  CHECK(energy < 0.5 * start_energy);
}

TEST_CASE("a hanging strand ends in equilibrium; its pin stays exactly where it is") {
  const auto model = make_model({6, 4}, true);
  const double stiffness = 2;
  add_energy(*model, std::make_unique<Springs>(stiffness));
  add_force(*model, std::make_unique<Weight>(gravity));
  const auto integrator = make_integrator("bdf1", *model);
  State state = rest_state(*model);
  for (int n = 0; n < 200; ++n) REQUIRE(integrator->step(*model, state, frame).failure.empty());
  for (const Pin& pin : model->pins) {
    CHECK(state.positions.get(pin.vertex) == model->strands.rest_position(pin.vertex));
    CHECK(state.velocities.get(pin.vertex).norm() == 0);
  }
  double carried = 0;
  for (int v = 5; v > 0; --v) {
    carried += model->strands.mass(v);
    const Eigen::Vector3d rest =
        model->strands.rest_position(v) - model->strands.rest_position(v - 1);
    const Eigen::Vector3d edge = state.positions.get(v) - state.positions.get(v - 1);
    CHECK((edge - rest).isApprox(carried / stiffness * gravity, 1e-6));
  }
}

TEST_CASE("a failed step leaves the state as it was") {
  const auto model = make_model({4, 4}, false);
  add_force(*model, std::make_unique<PointForce>([](int, const Eigen::Vector3d&) {
    return PointValue{std::numeric_limits<double>::quiet_NaN(), Eigen::Vector3d::Zero(),
                      Eigen::Matrix3d::Zero()};
  }));
  const auto integrator = make_integrator("bdf1", *model);
  State state = rest_state(*model);
  shake(*model, state);
  const State before = state;
  const StepReport report = integrator->step(*model, state, frame);
  CHECK_FALSE(report.failure.empty());
  CHECK(state.time == before.time);
  CHECK(state.positions.matrix() == before.positions.matrix());
  CHECK(state.velocities.matrix() == before.velocities.matrix());
}

TEST_CASE("the bits of a step do not depend on the number of threads") {
  const auto run = [](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const auto model = make_model(std::vector<int>(60, 15), true);
    add_energy(*model, std::make_unique<Springs>(0.5));
    add_force(*model, std::make_unique<Weight>(gravity));
    const auto integrator = make_integrator("bdf1", *model);
    State state = rest_state(*model);
    shake(*model, state);
    for (int n = 0; n < 5; ++n) integrator->step(*model, state, frame);
    return state.positions.matrix();
  };
  const Eigen::Matrix3Xd alone = run(1);
  CHECK(run(4) == alone);
}
