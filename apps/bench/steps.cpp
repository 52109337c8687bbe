// How long a time step of the hairball takes, stage by stage, beside the baseline.

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>

#include "apps/bench/baseline/baseline.h"
#include "apps/bench/bench.h"
#include "apps/bench/hairball.h"
#include "apps/bench/peak_memory.h"
#include "core/observer.h"
#include "core/read_choice.h"

namespace ringlet {
namespace {

/// Up to the number of wisps that is asked for, the largest.
std::set<int> sizes(const BenchOptions& options) {
  const int largest = options.strands_or(8000);
  std::set<int> wisps{largest};
  for (const int size : {500, 1000, 2000, 4000}) {
    if (size < largest) wisps.insert(size);
  }
  return wisps;
}

/// What is measured: so many steps after others that are not.
struct Case {
  int wisps;
  bool contacts;
  int skipped, steps;

  Case(int count, bool with_contacts, bool quick)
      : wisps(count),
        contacts(with_contacts),
        // With contacts, steps that lie in the first lean.
        skipped(quick           ? 0
                : with_contacts ? 45
                                : 5),
        steps(quick ? 1 : 15) {}
  Json scene() const { return contacts ? hairball(wisps) : hairball_without_contacts(wisps); }
};

BenchRow make_row(const Case& measured, const char* solver, int threads,
                  const StepFigures& figures) {
  BenchRow row{.name = "step",
               .parameters = {{"wisps", measured.wisps},
                              {"contacts", measured.contacts ? "on" : "off"},
                              {"threads", threads},
                              {"solver", solver}},
               .time = figures.step,
               .stages = as_json(figures.stages),
               .figures = {{"newton_iterations", figures.newton_iterations}}};
  if (measured.contacts) row.contacts = figures.contacts;
  if (figures.linear_iterations > 0) row.iterations = figures.linear_iterations;
  return row;
}

/// Of writing a frame for ParaView, s.
double output_seconds(const Registry& registry, const Simulation& simulation, double seconds) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::temp_directory_path() / ("ringlet_bench_" + std::to_string(getpid()));
  fs::create_directories(folder);
  const auto writer = make_chosen<Observer>(registry, "vtp");
  writer->begin(simulation.model(), simulation.state(), folder);
  int step = 0;
  const Timing timing = measure(
      [&] { writer->observe(simulation.model(), simulation.state(), ++step, {}); }, seconds);
  fs::remove_all(folder);
  return timing.median;
}

BenchRow measure_fast(const Registry& registry, const BenchOptions& options, const Case& measured,
                      int threads) {
  StepFigures figures;
  std::optional<Simulation> simulation;
  const auto bytes = peak_memory_during([&] {
    with_threads(threads, [&] {
      simulation.emplace(read_scene(measured.scene(), registry, "."));
      skip_steps(*simulation, measured.skipped);
      figures = measure_steps(*simulation, measured.steps);
    });
  });
  const char* solver = measured.contacts ? "strand_cholesky-PCG" : "strand_cholesky";
  BenchRow row = make_row(measured, solver, threads, figures);
  row.stages["output"] = output_seconds(registry, *simulation, options.seconds);
  row.bytes = bytes;
  return row;
}

/// On one thread, from the state in which the fast steps begin.
BenchRow measure_baseline(const Registry& registry, const Case& measured, BaselineSolver solver,
                          int steps) {
  StepFigures figures;
  std::optional<std::int64_t> bytes;
  with_threads(1, [&] {
    Simulation fast(read_scene(measured.scene(), registry, "."));
    skip_steps(fast, measured.skipped);
    bytes = peak_memory_during([&] {
      const Json plain = baseline_scene(measured.scene(), solver);
      Simulation simulation(read_scene(plain, with_baseline(registry), "."));
      simulation.set_state(fast.state());
      figures = measure_steps(simulation, steps);
    });
  });
  const bool is_ldlt = solver == BaselineSolver::ldlt;
  BenchRow row = make_row(measured, is_ldlt ? "baseline, LDLT" : "baseline, CG", 1, figures);
  row.name = "step/baseline";
  row.bytes = bytes;
  return row;
}

/// Adds the rows of the baseline; returns the time of its fastest solver a step and wisp, s.
double add_baseline(const Registry& registry, const Case& measured, BenchOutput& output) {
  constexpr int ldlt_steps = 3, cg_steps = 1;  // they all take about as long, and long
  BenchRow ldlt = measure_baseline(registry, measured, BaselineSolver::ldlt,
                                   std::min(ldlt_steps, measured.steps));
  output.add(ldlt);
  double fastest = ldlt.time->median;
  if (measured.contacts) {
    BenchRow cg =
        measure_baseline(registry, measured, BaselineSolver::conjugate_gradient, cg_steps);
    output.add(cg);
    fastest = std::min(fastest, cg.time->median);
  }
  return fastest / measured.wisps;
}

std::vector<Column> columns() {
  constexpr double milli = 1e-3, mega = 1e6;
  return {{"wisps", "/parameters/wisps"},
          {"contacts", "/parameters/contacts"},
          {"threads", "/parameters/threads"},
          {"solver", "/parameters/solver"},
          {"step", "/seconds", milli},
          {"spread", "/spread", milli},
          {"detect", "/stages/detect", milli},
          {"couple", "/stages/couple", milli},
          {"evaluate and factor", "/stages/evaluate", milli},
          {"solve", "/stages/solve", milli},
          {"line search", "/stages/line_search", milli},
          {"output, if any", "/stages/output", milli},
          {"Newton iterations", "/figures/newton_iterations"},
          {"CG iterations", "/iterations"},
          {"contacts found", "/contacts"},
          {"memory", "/bytes", mega},
          {"baseline takes x times as long", "/ratio"}};
}

}  // namespace

void bench_step(const Registry& registry, const BenchOptions& options, BenchOutput& output) {
  output.start_table(
      "Hairball, a step in ms: without contacts 3 Newton iterations, steps 6 to 20; with contacts "
      "to the default tolerances, steps 46 to 60, which lie in the first lean; a frame of output, "
      "which the step does not hold; the most memory, "
      "MB. The baseline runs on one thread, for few steps from the same state; its faster solver "
      "is compared with, a wisp",
      columns());
  // Fewer wisps hardly touch each other.
  constexpr int baseline_wisps = 2000;
  const std::set<int> wisps = sizes(options);
  const int compared = std::min(baseline_wisps, *wisps.rbegin());
  for (const bool contacts : {false, true}) {
    const double baseline =
        add_baseline(registry, Case(compared, contacts, options.quick()), output);
    for (const int count : wisps) {
      for (const int threads : std::set<int>{1, options.threads}) {
        BenchRow row =
            measure_fast(registry, options, Case(count, contacts, options.quick()), threads);
        row.ratio = baseline * count / row.time->median;
        output.add(row);
      }
    }
  }
}

}  // namespace ringlet
