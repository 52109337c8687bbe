// The orders of the integrators, by what halving the steps does to the result.

#include <cmath>

#include "core/kinetic_energy.h"
#include "tests/catch.h"
#include "tests/solvers/integrators/lively.h"

using namespace ringlet;

namespace {

constexpr double duration = 0.25;

struct Result {
  Eigen::Matrix3Xd positions, velocities;
};

/// uneven: steps of 1.5 and 0.5 times the length follow each other.
Result run(Json integrator, int steps, double uneven = 0) {
  const auto model = make_lively_model(0.7);
  integrator["dt"] = duration / steps;
  integrator["newton_tolerance"] = 1e-10;
  const auto made = make_integrator(integrator, *model);
  State state = thrown_state(*model);
  for (int n = 0; n < steps; ++n) {
    const double dt = duration / steps * (n % 2 == 0 ? 1 + uneven : 1 - uneven);
    const StepReport report = made->step(*model, state, dt);
    REQUIRE(report.failure.empty());
    REQUIRE(report.newton_converged);
  }
  CHECK(state.time == Approx(duration));
  return {state.positions.matrix(), state.velocities.matrix()};
}

/// The exponent p of errors that fall with dt^p: of positions, and of velocities.
std::pair<double, double> measure_orders(const Json& integrator, double uneven) {
  const Result coarse = run(integrator, 160, uneven), middle = run(integrator, 320, uneven),
               fine = run(integrator, 640, uneven);
  const auto order = [](const auto& a, const auto& b, const auto& c) {
    return std::log2((a - b).norm() / (b - c).norm());
  };
  return {order(coarse.positions, middle.positions, fine.positions),
          order(coarse.velocities, middle.velocities, fine.velocities)};
}

}  // namespace

TEST_CASE("errors fall with the order that the integrator states") {
  const auto model = make_lively_model(0);
  for (const double uneven : {0.0, 0.5}) {
    for (const Json& integrator :
         {Json{{"type", "bdf1"}}, Json{{"type", "bdf2"}}, Json{{"type", "newmark"}},
          Json{{"type", "newmark"}, {"gamma", 0.7}}}) {
      CAPTURE(integrator.dump(), uneven);
      const int stated = make_integrator(integrator, *model)->order();
      const auto [positions, velocities] = measure_orders(integrator, uneven);
      CHECK(std::abs(positions - stated) < 0.15);
      CHECK(std::abs(velocities - stated) < 0.15);
    }
  }
}

TEST_CASE("the integrators of second order agree, far better than with the one of first order") {
  const Result bdf1 = run({{"type", "bdf1"}}, 640), bdf2 = run({{"type", "bdf2"}}, 640),
               newmark = run({{"type", "newmark"}}, 640);
  const double apart = (bdf2.positions - newmark.positions).norm();
  CHECK(apart < 1e-3);
  CHECK(apart > 0);
  CHECK((bdf1.positions - newmark.positions).norm() > 30 * apart);
}

TEST_CASE("with gamma = 1/2 Newmark's method keeps the energy of a linear system, else it damps") {
  const auto energies = [](double gamma) {
    const auto model = make_model({4, 7, 5}, false);
    add_energy(*model, std::make_unique<Springs>(200 * model->strands.mass(1)));
    const auto integrator = make_integrator(
        {{"type", "newmark"}, {"gamma", gamma}, {"newton_tolerance", 1e-12}}, *model);
    State state = thrown_state(*model);
    std::vector<double> after;
    for (int n = 0; n < 200; ++n) {
      const StepReport report = integrator->step(*model, state, 0.03);
      REQUIRE(report.failure.empty());
      after.push_back(report.kinetic_energy + report.energies[0]);
    }
    return after;
  };
  const std::vector<double> kept = energies(0.5), damped = energies(0.7);
  REQUIRE(kept.front() > 0);
  for (const double energy : kept) CHECK(energy == Approx(kept.front()).epsilon(1e-9));
  CHECK(damped.back() < 0.7 * damped.front());
}

TEST_CASE("a state is all that is needed to go on, to the bit") {
  for (const char* type : {"bdf1", "bdf2", "newmark", "quasistatic"}) {
    CAPTURE(type);
    const auto model = make_lively_model(0.7);
    const auto first = make_integrator(type, *model), second = make_integrator(type, *model);
    State state = thrown_state(*model);
    for (int n = 0; n < 4; ++n) REQUIRE(first->step(*model, state, 0.02).failure.empty());
    State copy = state;
    for (int n = 0; n < 4; ++n) {
      REQUIRE(first->step(*model, state, 0.02).failure.empty());
      REQUIRE(second->step(*model, copy, 0.02).failure.empty());
    }
    CHECK(state.positions.matrix() == copy.positions.matrix());
    CHECK(state.velocities.matrix() == copy.velocities.matrix());
  }
}

TEST_CASE("a failed step leaves the state of any integrator as it was, to the bit") {
  for (const char* type : {"bdf1", "bdf2", "newmark", "quasistatic", "adaptive"}) {
    CAPTURE(type);
    const auto model = make_lively_model(0);
    bool is_broken = false;
    add_force(*model, std::make_unique<PointForce>([&](int, const Eigen::Vector3d&) {
      return PointValue{is_broken ? std::nan("") : 0, Eigen::Vector3d::Zero(),
                        Eigen::Matrix3d::Zero()};
    }));
    const auto integrator = make_integrator(type, *model);
    State state = thrown_state(*model);
    for (int n = 0; n < 2; ++n) REQUIRE(integrator->step(*model, state, 0.02).failure.empty());
    const State before = state;
    is_broken = true;
    CHECK_FALSE(integrator->step(*model, state, 0.02).failure.empty());
    CHECK(state.time == before.time);
    CHECK(state.positions.matrix() == before.positions.matrix());
    CHECK(state.velocities.matrix() == before.velocities.matrix());
    is_broken = false;
    State other = before;
    REQUIRE(integrator->step(*model, state, 0.02).failure.empty());
    REQUIRE(integrator->step(*model, other, 0.02).failure.empty());
    CHECK(state.positions.matrix() == other.positions.matrix());
  }
}
