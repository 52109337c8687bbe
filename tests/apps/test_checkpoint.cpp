// A checkpoint is all that a simulation needs to go on, whatever the scene.

#include "collision/modules.h"
#include "core/modules.h"
#include "core/simulation.h"
#include "energies/modules.h"
#include "solvers/modules.h"
#include "tests/apps/program.h"
#include "tests/catch.h"

using namespace ringlet;

namespace {

/// A wind that grows with each step that was begun: more than StepStart tells.
class GrowingWind final : public Force {
 public:
  explicit GrowingWind(const NoParameters&) {}
  void bind(const Strands&, const StrandGroups&) override {}
  void begin_step(const StepStart&) override { force_ += 1e-7; }
  std::span<std::byte> changing_data() override {
    return std::as_writable_bytes(std::span(&force_, 1));
  }
  double add(int, std::span<const Vector3<Pack>> x, GroupOutputs outputs) const override {
    Pack energy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      energy -= force_ * x[i].x;
      if (!outputs.gradient.empty()) outputs.gradient[i].x -= Pack(force_);
    }
    return sum_lanes(energy);
  }

 private:
  double force_ = 0;  // N
};

Scene read(const Json& json) {
  Registry registry;
  register_core(registry);
  register_energies(registry);
  register_solvers(registry);
  register_collision(registry);
  registry.of<Force>().add<NoParameters>("growing_wind", {}, [](const NoParameters& parameters) {
    return std::make_unique<GrowingWind>(parameters);
  });
  return read_scene(json, registry, ".");
}

void step(Simulation& simulation, int steps) {
  for (int n = 0; n < steps; ++n) {
    const StepReport report = simulation.step();
    CAPTURE(report.failure);
    REQUIRE(report.failure.empty());
  }
}

Json with(const char* pointer, const Json& value) {
  Json scene = small_scene();
  scene["run"]["write"] = Json::array();
  scene["material"]["youngs_modulus"] = 1e5;
  scene[Json::json_pointer(pointer)] = value;
  return scene;
}

}  // namespace

TEST_CASE("a simulation goes on from a checkpoint to the bit") {
  const Json scene =
      GENERATE(with("/integrator", "bdf1"), with("/integrator", "bdf2"),
               with("/integrator", "newmark"), with("/integrator", "quasistatic"),
               with("/integrator", {{"type", "adaptive"}, {"halvings", 3}}),
               with("/integrator", {{"type", "bdf1"}, {"sleep_speed", 0.05}, {"sleep_steps", 2}}),
               with("/forces", {"gravity", "growing_wind"}), with("/collision/friction", 0.5),
               with("/collision/response", "barrier"), with("/collision/audit", true),
               with("/collision/detect", "step"), with("/collision/detector", "grid"),
               with("/solver", "cholesky"));
  const int before = GENERATE(1, 7);
  CAPTURE(scene.dump(), before);
  const Scene read_once = read(scene);
  Simulation whole(read_once), second(read_once);
  step(whole, before);
  second.go_on_from(whole.checkpoint());
  CHECK(second.steps_done() == before);
  CHECK(second.state().time == whole.state().time);
  step(whole, 8);
  step(second, 8);
  CHECK(second.checkpoint() == whole.checkpoint());
  CHECK(second.state().positions.matrix() == whole.state().positions.matrix());
  CHECK(
      (whole.state().positions.matrix() - Simulation(read_once).state().positions.matrix()).norm() >
      1e-4);
}

TEST_CASE("a checkpoint of something else is refused, and nothing changes") {
  Simulation simulation(read(with("/solver", "auto")));
  Simulation windy(read(with("/forces", {"gravity", "growing_wind"})));
  Simulation few(read(with("/strands/count", 2)));
  const std::string start = simulation.checkpoint();
  using Catch::Contains;
  CHECK_THROWS_WITH(simulation.go_on_from(few.checkpoint()), Contains("30 vertices; expected 300"));
  CHECK_THROWS_WITH(simulation.go_on_from(windy.checkpoint()), Contains("8 bytes; expected 0"));
  CHECK_THROWS_WITH(simulation.go_on_from(start + "x"), Contains("after its end"));
  for (const std::size_t length : {0ul, 20ul, 100ul, start.size() / 2, start.size() - 1}) {
    CHECK_THROWS_AS(simulation.go_on_from(start.substr(0, length)), Error);
  }
  std::string other = start;
  other.replace(other.find("ringlet "), 10, "ringlet 99");
  CHECK_THROWS_WITH(simulation.go_on_from(other), Contains("written by ringlet 99"));
  CHECK(simulation.checkpoint() == start);
}
