// What the filters of the Hessian cost, how far they are above the numeric clamp, and how many
// Newton iterations they take.

#include <algorithm>
#include <numeric>

#include "apps/bench/element_timing.h"
#include "core/batch_energy.h"
#include "core/simulation.h"
#include "core/verify/shapes.h"

namespace ringlet {
namespace {

/// Traces of the filtered Hessians of random elements relative to those of the numeric clamp,
/// ascending.
std::vector<double> relative_traces(const EnergyMaker& make, const std::string& filter,
                                    int element_vertices, int trials) {
  std::mt19937_64 random(5);
  std::vector<double> traces;
  for (int trial = 0; trial < trials; ++trial) {
    const Points rest = random_strand(random, element_vertices, Shape::generic);
    const Points x = random_strand(random, element_vertices, Shape::generic);
    const double clamp = BoundEnergy(make({{"filter", "clamp"}}), rest).at(x).hessian.trace();
    const double own = BoundEnergy(make({{"filter", filter}}), rest).at(x).hessian.trace();
    traces.push_back(own / clamp);
  }
  std::sort(traces.begin(), traces.end());
  return traces;
}

void bench_costs(const Registry& registry, const BenchOptions& options, BenchOutput& output) {
  output.start_table(
      "Filters: an element with gradient and Hessian, in lanes on one thread; trace of "
      "the Hessian of 400 random elements relative to that of the numeric clamp",
      {{"energy", "/parameters/energy"},
       {"filter", "/parameters/filter"},
       {"ns an element", "/seconds", 1e-9},
       {"spread", "/spread", 1e-9},
       {"clamp takes x times as long", "/ratio"},
       {"trace, median", "/figures/median_trace"},
       {"trace, worst", "/figures/worst_trace"}});
  for (const std::string& name : registry.of<Energy>().names()) {
    const EnergyMaker make = energy_maker(registry, name);
    const auto energy = make(Json::object());
    if (energy->element_function() == nullptr) continue;
    const int vertices = energy->element_function()->vertices();
    const double clamp = time_element(make, {{"filter", "clamp"}}, options).median;
    for (const auto& [filter, filter_name] : EnumNames<Filter>::names) {
      const Timing timing = time_element(make, {{"filter", filter_name}}, options);
      const auto traces = relative_traces(make, filter_name, vertices, options.quick() ? 5 : 400);
      output.add({.name = "filters/element",
                  .parameters = {{"energy", name}, {"filter", filter_name}},
                  .time = timing,
                  .ratio = clamp / timing.median,
                  .figures = {{"median_trace", traces[traces.size() / 2]},
                              {"worst_trace", traces.back()}}});
    }
  }
}

/// Newton iterations of each step of a scene with that filter in all energies.
std::vector<int> newton_iterations(const Registry& registry, const std::string& scene_name,
                                   const char* filter, int steps, int cap) {
  constexpr double tolerance = 1e-8;
  Json json = bundled_scene(scene_name);
  for (Json& energy : json["energies"]) {
    if (energy.is_string()) energy = {{"type", energy}};
    energy["filter"] = filter;
  }
  json["integrator"].update({{"newton_tolerance", tolerance}, {"newton_iterations", cap}});
  Simulation simulation(read_scene(json, registry, "."));
  std::vector<int> iterations;
  for (int step = 0; step < steps; ++step) {
    const StepReport report = simulation.step();
    if (!report.failure.empty()) throw Error(scene_name + ", " + filter + ": " + report.failure);
    iterations.push_back(report.newton_iterations);
  }
  return iterations;
}

void bench_newton(const Registry& registry, const BenchOptions& options, BenchOutput& output) {
  const std::vector<std::string> scenes{"smash", "jitter", "hanging_curl"};
  std::vector<Column> columns{{"filter", "/parameters/filter"}};
  for (const std::string& scene : scenes) {
    columns.push_back({scene + ", first", "/figures/" + scene + "/first"});
    columns.push_back({scene + ", mean", "/figures/" + scene + "/mean"});
  }
  output.start_table(
      "Filters: Newton iterations until no vertex moves by more than 1e-8 m/s times dt; "
      "of the first step, and the mean of 30 steps",
      columns);
  for (const auto& [filter, name] : EnumNames<Filter>::names) {
    BenchRow row{.name = "filters/newton", .parameters = {{"filter", name}}};
    for (const std::string& scene : scenes) {
      const auto counts = options.quick() ? newton_iterations(registry, scene, name, 1, 2)
                                          : newton_iterations(registry, scene, name, 30, 2000);
      const double sum = std::accumulate(counts.begin(), counts.end(), 0.0);
      row.figures[scene] = {{"first", counts[0]}, {"mean", sum / counts.size()}};
    }
    output.add(row);
  }
}

}  // namespace

void bench_filters(const Registry& registry, const BenchOptions& options, BenchOutput& output) {
  bench_costs(registry, options, output);
  bench_newton(registry, options, output);
}

}  // namespace ringlet
