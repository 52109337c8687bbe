#include "solvers/modules.h"
#include "tests/catch.h"
#include "tests/solvers/integrators/lively.h"

using namespace ringlet;

namespace {

constexpr double whole_step = 0.05;

/// Ten steps; the largest distance of a vertex to a far finer solution, and the substeps taken.
struct Measured {
  double error;
  int substeps;
};

Eigen::Matrix3Xd run(const Json& json, int steps, double duration, int& substeps) {
  const auto model = make_lively_model(0.7);
  const auto integrator = make_integrator(json, *model);
  State state = thrown_state(*model);
  substeps = 0;
  for (int n = 0; n < steps; ++n) {
    const StepReport report = integrator->step(*model, state, duration / steps);
    REQUIRE(report.failure.empty());
    CHECK(report.local_error_met);
    substeps += report.substeps;
  }
  CHECK(state.time == Approx(duration));
  return state.positions.matrix();
}

Measured measure(const std::string& integrator, double tolerance) {
  int substeps = 0;
  const Json fine{{"type", "newmark"}, {"newton_tolerance", 1e-10}};
  static const Eigen::Matrix3Xd reference = run(fine, 20000, 0.5, substeps);
  const Json json{{"type", "adaptive"},
                  {"integrator", {{"type", integrator}, {"newton_tolerance", 1e-9}}},
                  {"tolerance", tolerance},
                  {"halvings", 14}};
  const Eigen::Matrix3Xd reached = run(json, 10, 0.5, substeps);
  return {(reached - reference).colwise().norm().maxCoeff(), substeps};
}

/// Fails at steps that are longer than a limit, else moves everything by its velocity.
struct Fragile final : Integrator {
  struct Parameters {
    double limit = 1;
    static Schema<Parameters> schema() {
      return Schema<Parameters>().key("limit", &Parameters::limit, "s", positive(), "");
    }
  };
  explicit Fragile(const Parameters& given) : parameters(given) {}
  double time_step() const override { return whole_step; }
  int order() const override { return 1; }
  void bind(const Model&) override {}
  StepReport step(Model& model, State& state, double step) override {
    StepReport report;
    begin_step(model, state, step, {state.positions, step});
    if (step > parameters.limit) {
      report.failure = "it broke";
      return report;
    }
    add_scaled(state.positions, step, state.velocities);
    state.time += step;
    state.history.dt = step;
    return report;
  }
  Parameters parameters;
};

/// Counts the steps that were begun and kept.
struct CountingEnergy final : Energy {
  void bind(const Strands&, const StrandGroups&) override {}
  void begin_step(const StepStart&) override { ++begun; }
  std::span<std::byte> changing_data() override {
    return std::as_writable_bytes(std::span(&begun, 1));
  }
  double add(int, std::span<const Vector3<Pack>>, EdgeOutputs) const override { return 0; }
  int begun = 0;
};

struct FragileRun {
  explicit FragileRun(double limit) : model(make_model({3, 4}, false)), state(thrown()) {
    Registry registry;
    register_solvers(registry);
    registry.of<Integrator>().add<Fragile::Parameters>(
        "fragile", {}, [](const Fragile::Parameters& p) { return std::make_unique<Fragile>(p); });
    auto owned = std::make_unique<CountingEnergy>();
    energy = owned.get();
    add_energy(*model, std::move(owned));
    integrator = make_integrator(registry,
                                 {{"type", "adaptive"},
                                  {"integrator", {{"type", "fragile"}, {"limit", limit}}},
                                  {"halvings", 4}},
                                 *model);
  }
  State thrown() const { return thrown_state(*model); }

  std::unique_ptr<Model> model;
  State state;
  CountingEnergy* energy = nullptr;
  std::unique_ptr<Integrator> integrator;
};

}  // namespace

TEST_CASE("the smaller the tolerance, the smaller the error and the more the substeps") {
  for (const char* integrator : {"bdf1", "bdf2", "newmark"}) {
    CAPTURE(integrator);
    const Measured loose = measure(integrator, 1e-3), tight = measure(integrator, 1e-5);
    // Ten steps may each add the tolerance, and what was added grows or decays on the way.
    CHECK(loose.error < 5e-2);
    CHECK(tight.error < 3e-4);
    CHECK(tight.error > 0);
    CHECK(tight.substeps > loose.substeps);
  }
  CHECK(measure("bdf1", 1e-5).substeps > 5 * measure("bdf2", 1e-5).substeps);
}

TEST_CASE("where an integrator fails, the step is divided, and only what is kept counts") {
  FragileRun run(0.3 * whole_step);
  const Eigen::Matrix3Xd start = run.state.positions.matrix();
  const StepReport report = run.integrator->step(*run.model, run.state, whole_step);
  REQUIRE(report.failure.empty());
  CHECK(report.substeps == 8);
  CHECK(run.energy->begun == 8);
  CHECK(run.state.time == whole_step);
  const Eigen::Matrix3Xd moved = start + whole_step * run.state.velocities.matrix();
  CHECK((run.state.positions.matrix() - moved).norm() < 1e-12);
}

TEST_CASE(
    "where it fails at the smallest part as well, the report says so and nothing has changed") {
  FragileRun run(0.01 * whole_step);
  const State before = run.state;
  const StepReport report = run.integrator->step(*run.model, run.state, whole_step);
  CHECK(report.failure.find("it broke") != std::string::npos);
  CHECK(report.failure.find("smallest part") != std::string::npos);
  CHECK(run.state.time == before.time);
  CHECK(run.state.positions.matrix() == before.positions.matrix());
  CHECK(run.energy->begun == 0);
}

TEST_CASE("an error that even the smallest parts exceed is told") {
  const auto model = make_lively_model(0);
  const auto integrator =
      make_integrator({{"type", "adaptive"}, {"tolerance", 1e-9}, {"halvings", 1}}, *model);
  State state = thrown_state(*model);
  const StepReport report = integrator->step(*model, state, whole_step);
  REQUIRE(report.failure.empty());
  CHECK_FALSE(report.local_error_met);
  CHECK(report.local_error > 1e-9);
  CHECK(report.substeps == 4);
}

TEST_CASE("a state is all that adaptive steps need to go on, to the bit") {
  const auto model = make_lively_model(0.7);
  const auto first = make_integrator("adaptive", *model),
             second = make_integrator("adaptive", *model);
  State state = thrown_state(*model);
  for (int n = 0; n < 3; ++n) REQUIRE(first->step(*model, state, whole_step).failure.empty());
  State copy = state;
  REQUIRE(first->step(*model, state, whole_step).failure.empty());
  REQUIRE(second->step(*model, copy, whole_step).failure.empty());
  CHECK(state.positions.matrix() == copy.positions.matrix());
}
