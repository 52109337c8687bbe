// What a plugin throws in the middle of a run ends the run with its kind and name, whatever kind it
// is of.

#include <algorithm>

#include "apps/scene_run.h"
#include "collision/modules.h"
#include "core/batch_coupling.h"
#include "core/collider.h"
#include "core/contact_detector.h"
#include "core/contact_energy.h"
#include "core/integrator.h"
#include "core/modules.h"
#include "core/motion.h"
#include "core/observer.h"
#include "core/pose.h"
#include "core/rest_state.h"
#include "core/simulation.h"
#include "core/strand_source.h"
#include "energies/modules.h"
#include "solvers/modules.h"
#include "tests/apps/program.h"
#include "tests/catch.h"

using namespace ringlet;

namespace {

[[noreturn]] void fail() { throw std::runtime_error("out of luck"); }

struct FailingSource final : StrandSource {
  StrandSet generate() const override { fail(); }
};
struct FailingRoots final : RootSource {
  std::vector<Root> place(int, unsigned) const override { fail(); }
};
struct FailingPose final : Pose {
  void apply(const Strands&, const std::vector<int>&,
             std::vector<Eigen::Vector3d>&) const override {
    fail();
  }
};
struct FailingRestState final : RestState {
  RestReport choose(Model&) const override { fail(); }
};
struct FailingMotion final : Motion {
  Eigen::Isometry3d at(double time) const override {
    if (time > 0) fail();
    return Eigen::Isometry3d::Identity();
  }
};
struct FailingEnergy final : Energy {
  void bind(const Strands&, const StrandGroups&) override {}
  void begin_step(const StepStart&) override { fail(); }
  double add(int, std::span<const Vector3<Pack>>, EdgeOutputs) const override { return 0; }
};
struct FailingCoupling final : CouplingEnergy {
  void bind(const Strands&, const StrandGroups&) override {}
  double add(const VertexField&, Couplings*) const override { fail(); }
};
struct FailingForce final : Force {
  void bind(const Strands&, const StrandGroups&) override {}
  void begin_step(const StepStart&) override {}
  double add(int, std::span<const Vector3<Pack>>, GroupOutputs) const override { fail(); }
};
struct FailingSolver final : LinearSolver {
  void bind(const StrandGroups&) override {}
  bool prepare(const SystemMatrix&) override { fail(); }
  SolveReport solve(const VertexField&, VertexField&) override { return {}; }
};
struct FailingIntegrator final : Integrator {
  double time_step() const override { return 1; }
  void bind(const Model&) override {}
  int order() const override { return 1; }
  StepReport step(Model&, State&, double) override { fail(); }
};
struct FailingDetector final : ContactDetector {
  void bind(const Strands&) override {}
  void find(std::span<const Eigen::Vector3d>, double, std::vector<EdgePair>&) override { fail(); }
};
struct FailingResponse final : ContactEnergy {
  DistanceEnergy at(double, double, double) const override { fail(); }
  bool is_barrier() const override { return false; }
};
struct FailingCollider final : Collider {
  ColliderPlacement where;
  const ColliderPlacement& placement() const override { return where; }
  void near(std::span<const Eigen::Vector3d>, double,
            std::span<std::optional<Proximity>>) const override {
    fail();
  }
};

struct FailingWriter final : Observer {
  void begin(const Model&, const State&, const std::filesystem::path&) override {}
  void observe(const Model&, const State&, int step, const StepReport&) override {
    if (step == 2) fail();
  }
  void end(const Model&, const State&, int) override {}
};

template <class Interface, class Failing>
void add(Registry& registry) {
  registry.of<Interface>().template add<NoParameters>(
      "failing", {}, [](const NoParameters&) { return std::make_unique<Failing>(); });
}

/// The error of a scene with one key changed, or of its first step.
std::string failure(const std::string& pointer, const Json& value) {
  Registry registry;
  register_core(registry);
  register_energies(registry);
  register_solvers(registry);
  register_collision(registry);
  add<StrandSource, FailingSource>(registry);
  add<RootSource, FailingRoots>(registry);
  add<Pose, FailingPose>(registry);
  add<RestState, FailingRestState>(registry);
  add<Motion, FailingMotion>(registry);
  add<Energy, FailingEnergy>(registry);
  add<CouplingEnergy, FailingCoupling>(registry);
  add<Force, FailingForce>(registry);
  add<LinearSolver, FailingSolver>(registry);
  add<Integrator, FailingIntegrator>(registry);
  add<ContactDetector, FailingDetector>(registry);
  add<ContactEnergy, FailingResponse>(registry);
  add<Collider, FailingCollider>(registry);
  Json scene = Json::parse(R"({
    "motions": {"head": [{"type": "sinusoid", "frequency": 1, "angle": 0.1}]},
    "strands": {"type": "line", "vertices": 12, "length": 0.1, "motion": "head",
                "roots": {"type": "point", "position": [0, 0.1, 0], "direction": [0, -1, 0]}},
    "energies": ["stretch"], "forces": ["gravity"],
    "collision": {"type": "fcl", "colliders": [{"type": "plane", "point": [0, 0.0005, 0], "normal": [0, 1, 0]}]}})");
  scene[Json::json_pointer(pointer)] = value;
  try {
    Simulation simulation(read_scene(scene, registry, "/"));
    return simulation.step().failure;
  } catch (const PluginError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE("what a plugin throws in a run is told with its kind and name") {
  CHECK(failure("/about", "nothing wrong").empty());
  const std::tuple<std::string, Json, std::string> cases[] = {
      {"/strands", "failing", "strand source"},
      {"/strands/roots", "failing", "root source"},
      {"/start", {"failing"}, "start pose"},
      {"/rest", "failing", "rest state"},
      {"/motions/head/0", "failing", "motion"},
      {"/energies/0", "failing", "energy"},
      {"/couplings", {"failing"}, "coupling"},
      {"/forces/0", "failing", "force"},
      {"/solver", "failing", "linear solver"},
      {"/solver", {{"type", "pcg"}, {"preconditioner", "failing"}}, "linear solver"},
      {"/integrator", "failing", "integrator"},
      {"/collision/detector", "failing", "contact detector"},
      {"/collision/response", "failing", "contact energy"},
      {"/collision/colliders/0", "failing", "collider"}};
  for (const auto& [pointer, value, kind] : cases) {
    CHECK(failure(pointer, value) == kind + " 'failing': out of luck");
  }
}

TEST_CASE("a writer that fails ends the run with its name; what was written so far stays") {
  Registry registry;
  register_core(registry);
  register_energies(registry);
  register_solvers(registry);
  add<Observer, FailingWriter>(registry);
  const Scene scene = read_scene(Json::parse(R"({"strands": {"type": "line", "vertices": 4},
    "run": {"steps": 5, "write": ["failing"]}})"),
                                 registry, "/");
  Simulation simulation(scene);
  const Workplace place;
  const RunRecord record =
      SceneRun(scene, simulation, place.folder()).run("test", Telling::nothing);
  CHECK(record.failure == "writer 'failing': out of luck");
  CHECK(record.steps == 2);
  const auto files = read_files(place.folder());
  CHECK(std::count(files.at("metrics.csv").begin(), files.at("metrics.csv").end(), '\n') == 3);
  CHECK_THAT(files.at("summary.json"), Catch::Contains("failed"));
}
