// A scene pays for nothing that it does not ask for: a test for each module.

#include <algorithm>

#include "collision/modules.h"
#include "core/batch_energy.h"
#include "core/module_costs.h"
#include "core/modules.h"
#include "energies/modules.h"
#include "solvers/modules.h"
#include "tests/apps/program.h"
#include "tests/catch.h"
#include "tests/simulate.h"

using namespace ringlet;

namespace {

std::vector<ModuleCost> costs_of(const Json& scene, StepReport* last = nullptr) {
  Simulation simulation = simulate(scene.dump());
  for (int n = 0; n < 3; ++n) {
    const StepReport report = simulation.step();
    REQUIRE(report.failure.empty());
    if (last != nullptr) *last = report;
  }
  return list_costs(simulation);
}

const ModuleCost* find(const std::vector<ModuleCost>& costs, const std::string& kind,
                       const std::string& name) {
  const auto found = std::find_if(costs.begin(), costs.end(), [&](const ModuleCost& cost) {
    return cost.kind == kind && (name.empty() || cost.name == name);
  });
  return found == costs.end() ? nullptr : &*found;
}

Eigen::Matrix3Xd positions_after(const Json& scene, int steps) {
  Simulation simulation = simulate(scene.dump());
  for (int n = 0; n < steps; ++n) REQUIRE(simulation.step().failure.empty());
  return simulation.state().positions.matrix();
}

Json quiet_scene() {
  Json scene = small_scene();
  scene["run"]["write"] = Json::array();
  return scene;
}

}  // namespace

TEST_CASE("each part that a scene asks for is listed with what it costs") {
  const auto costs = costs_of(quiet_scene());
  for (const auto& [kind, name] :
       std::vector<std::pair<std::string, std::string>>{{"energy", "stretch"},
                                                        {"energy", "bending"},
                                                        {"energy", "twist"},
                                                        {"force", "gravity"},
                                                        {"collision stage", "fcl"},
                                                        {"linear solver", "pcg"},
                                                        {"integrator", "bdf1"}}) {
    CAPTURE(kind, name);
    const ModuleCost* cost = find(costs, kind, name);
    REQUIRE(cost != nullptr);
    CHECK(cost->seconds > 0);
    // What a solver holds belongs to contacts, and there are none.
    CHECK((cost->bytes > 0) == (kind != "linear solver"));
    CHECK_FALSE(cost->left_out);
  }
  for (const char* kind : {"strands", "state"}) {
    REQUIRE(find(costs, kind, "") != nullptr);
    CHECK(find(costs, kind, "")->bytes > 0);
  }
}

TEST_CASE("energies and forces that are always zero are left out, and change nothing") {
  Json scene = quiet_scene();
  scene["material"]["shear_modulus"] = 0;
  scene["forces"] = {{{"type", "gravity"}, {"acceleration", {0, 0, 0}}},
                     {{"type", "drag"}, {"coefficient", 0}},
                     {{"type", "rayleigh"}}};
  scene["start"] = {{{"type", "scale"}, {"factors", {0.7, 1, 1}}}};
  const auto costs = costs_of(scene);
  for (const auto& [kind, name] : std::vector<std::pair<std::string, std::string>>{
           {"energy", "twist"}, {"force", "gravity"}, {"force", "drag"}, {"force", "rayleigh"}}) {
    CAPTURE(name);
    const ModuleCost* cost = find(costs, kind, name);
    REQUIRE(cost != nullptr);
    CHECK(cost->left_out);
    CHECK(cost->seconds == 0);
    CHECK(cost->bytes == 0);
  }
  CHECK_FALSE(find(costs, "energy", "bending")->left_out);
  Json without = scene;
  without["energies"] = {"stretch", "bending"};
  without["forces"] = Json::array();
  CHECK(positions_after(scene, 4) == positions_after(without, 4));
}

TEST_CASE("what is left out has a column of zeros, and is told in the summary") {
  const Workplace place;
  Json scene = quiet_scene();
  scene["material"]["shear_modulus"] = 0;
  const std::string file = place.write("s.json", scene.dump());
  REQUIRE(place.run({"run", file, "-o", "out"}).exit_code == 0);
  const auto metrics = read_metrics(place.folder() / "out/metrics.csv");
  CHECK(metrics.at("energy_twist") == std::vector<double>(6, 0.0));
  CHECK(metrics.at("energy_bending").back() > 0);
  const Json summary = Json::parse(read_text(place.folder() / "out/summary.json"));
  const bool is_told =
      std::any_of(summary["modules"].begin(), summary["modules"].end(), [](const Json& module) {
        return module.value("name", "") == "twist" && module.contains("left_out");
      });
  CHECK(is_told);
}

TEST_CASE("without collision there is neither its module nor its stages") {
  Json scene = quiet_scene();
  scene["collision"] = nullptr;
  StepReport last;
  const auto costs = costs_of(scene, &last);
  CHECK(find(costs, "collision stage", "") == nullptr);
  CHECK(last.seconds.detect == 0);
  CHECK(last.seconds.couple == 0);
}

TEST_CASE("writers are listed only if a scene has some, and then with their time") {
  const auto writers = [](const Json& scene) {
    const Workplace place;
    const std::string file = place.write("s.json", scene.dump());
    REQUIRE(place.run({"run", file, "-o", "out"}).exit_code == 0);
    std::vector<double> seconds;
    const Json summary = Json::parse(read_text(place.folder() / "out/summary.json"));
    for (const Json& module : summary["modules"]) {
      if (module["kind"] == "writer") seconds.push_back(module["seconds"]);
    }
    return seconds;
  };
  CHECK(writers(quiet_scene()).empty());
  const auto seconds = writers(small_scene());
  REQUIRE(seconds.size() == 1);
  CHECK(seconds[0] > 0);
}

namespace {

/// Remembers of which groups derivatives were wanted.
class Recording final : public Energy {
 public:
  explicit Recording(std::vector<int>& wanted) : wanted_(wanted) {}
  void bind(const Strands&, const StrandGroups& groups) override {
    wanted_.assign(groups.count(), 0);
  }
  double add(int group, std::span<const Vector3<Pack>>, EdgeOutputs outputs) const override {
    if (!outputs.hessian.empty()) wanted_[group] = 1;
    return 0;
  }

 private:
  std::vector<int>& wanted_;
};

/// Curls, and among them as many that are pinned as a whole.
Json half_pinned_scene() {
  Json scene = quiet_scene();
  Json free = scene["strands"], held = scene["strands"];
  held["pinned"] = 15;
  held["roots"]["position"] = {0.003, 0, 0};
  scene["strands"] = {held, free};
  scene["material"]["youngs_modulus"] = 1e6;
  return scene;
}

}  // namespace

TEST_CASE("strands that are pinned as a whole are not solved") {
  std::vector<int> wanted;
  Registry registry;
  register_core(registry);
  register_energies(registry);
  register_solvers(registry);
  register_collision(registry);
  registry.of<Energy>().add<NoParameters>(
      "recording", {}, [&](const NoParameters&) { return std::make_unique<Recording>(wanted); });
  Json json = half_pinned_scene();
  json["energies"].push_back("recording");
  Simulation simulation(read_scene(json, registry, "."));
  for (int n = 0; n < 3; ++n) REQUIRE(simulation.step().failure.empty());
  const int needed = (20 + lane_count - 1) / lane_count;
  CHECK(std::count(wanted.begin(), wanted.end(), 1) == needed);
  CHECK(static_cast<int>(wanted.size()) == 2 * needed);
}

TEST_CASE("all solvers agree beside strands that are pinned as a whole") {
  const auto run = [](const Json& solver) {
    Json scene = half_pinned_scene();
    scene["solver"] = solver;
    scene["integrator"] = {{"type", "bdf1"}, {"newton_tolerance", 1e-8}};
    return positions_after(scene, 10);
  };
  const Eigen::Matrix3Xd exact = run("cholesky");
  const Eigen::Matrix3Xd start = positions_after(half_pinned_scene(), 0);
  CHECK((exact - start).leftCols(20 * 15).isZero(0));
  CHECK((exact - start).rightCols(20 * 15).norm() > 1e-4);
  for (const Json& solver :
       {Json{{"type", "pcg"}, {"tolerance", 1e-10}}, Json{"auto"},
        Json{{"type", "pcg"}, {"tolerance", 1e-10}, {"preconditioner", "jacobi"}}}) {
    const Json chosen = solver.is_array() ? solver[0] : solver;
    CAPTURE(chosen.dump());
    CHECK((run(chosen) - exact).norm() < 1e-6);
  }
}

namespace {

/// A spring of no rest length that remembers which filters it was asked for.
struct Asked {
  static constexpr int vertices = 2;
  using Parameters = NoParameters;
  template <class S>
  struct Rest {
    S stiffness;
  };
  std::vector<Filter>* filters;

  Rest<double> rest(const ElementRest<2>&) const { return {1}; }
  template <class S>
  S value(const Stencil<S, 2>& x, const Rest<S>& rest) const {
    return S(0.5) * rest.stiffness * squared_norm(x[1] - x[0]);
  }
  template <class S>
  S evaluate(const Stencil<S, 2>& x, const Rest<S>& rest, Filter filter,
             ElementOutputs<S, 2> outputs) const {
    filters->push_back(filter);
    outputs.add_gradient(0, rest.stiffness * (x[1] - x[0]));
    return value(x, rest);
  }
};

std::int64_t operations_of(const std::string& filter) {
  Json scene = quiet_scene();
  scene["energies"] = {{{"type", "twist"}, {"filter", filter}}};
  const Simulation simulation = simulate(scene.dump());
  Eigen::Matrix3Xd x(3, 4);
  x << 0, 1, 1.2, 2, 0, 0.1, 1, 1.3, 0, 0, 0.2, 1;
  return simulation.model().energies[0]->element_function()->cost(x, 1, 0.3).operations;
}

}  // namespace

TEST_CASE("no Hessian is filtered where only values are wanted, and no other than chosen") {
  const std::vector<Eigen::Vector3d> rest{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 2, 0}, {0, 4, 0}};
  const Strands strands({2, 3}, rest, Material{});
  const StrandGroups groups(strands);
  const VertexField x = positions_with_pads(groups, rest);
  for (const Filter filter : {Filter::tight, Filter::paper, Filter::gauss_newton, Filter::exact}) {
    std::vector<Filter> asked;
    BatchEnergy<Asked> energy(Asked{&asked}, filter, Evaluation::lanes);
    energy.bind(strands, groups);
    energy.add(0, x.group(0), {});
    CHECK(asked.empty());
    StrandBands bands(groups);
    VertexField gradient(groups);
    add_at_vertices(energy, 0, x.group(0), {gradient.group(0), bands.group(0)});
    CHECK(asked == std::vector<Filter>(2, filter));
  }
}

TEST_CASE("a filter that keeps less of the Hessian takes fewer operations") {
  CHECK(operations_of("gauss_newton") < operations_of("tight"));
  CHECK(operations_of("tight") < operations_of("exact"));
  // What the numeric ones take comes on top of the exact Hessian.
  CHECK(operations_of("clamp") == operations_of("exact"));
}
