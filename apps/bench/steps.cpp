// How long a time step of the hairball takes, stage by stage.

#include <set>

#include "apps/bench/bench.h"
#include "apps/bench/hairball.h"
#include "apps/bench/peak_memory.h"

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

/// Of steps that lie in the first lean where there are contacts.
BenchRow measure_row(const Registry& registry, const BenchOptions& options, int wisps,
                     bool contacts, int threads) {
  const Json scene = contacts ? hairball(wisps) : hairball_without_contacts(wisps);
  const auto [first, last] = options.quick() ? std::pair(1, 1)
                             : contacts      ? std::pair(46, 60)
                                             : std::pair(6, 20);
  StepFigures figures;
  const auto bytes = peak_memory_during([&] {
    with_threads(threads, [&] { figures = measure_steps(registry, scene, first, last); });
  });
  BenchRow row{
      .name = "step",
      .parameters = {{"wisps", wisps}, {"contacts", contacts ? "on" : "off"}, {"threads", threads}},
      .time = figures.step,
      .stages = as_json(figures.stages),
      .bytes = bytes,
      .figures = {{"newton_iterations", figures.newton_iterations}}};
  if (contacts) {
    row.iterations = figures.linear_iterations;
    row.contacts = figures.contacts;
  }
  return row;
}

}  // namespace

void bench_step(const Registry& registry, const BenchOptions& options, BenchOutput& output) {
  constexpr double milli = 1e-3, mega = 1e6;
  output.start_table(
      "Hairball, a step in ms: without contacts 3 Newton iterations, steps 6 to 20; with contacts "
      "to the default tolerances, steps 46 to 60, which lie in the first lean; the most memory, MB",
      {{"wisps", "/parameters/wisps"},
       {"contacts", "/parameters/contacts"},
       {"threads", "/parameters/threads"},
       {"step", "/seconds", milli},
       {"spread", "/spread", milli},
       {"detect", "/stages/detect", milli},
       {"evaluate and factor", "/stages/evaluate", milli},
       {"solve", "/stages/solve", milli},
       {"line search", "/stages/line_search", milli},
       {"Newton iterations", "/figures/newton_iterations"},
       {"CG iterations", "/iterations"},
       {"contacts found", "/contacts"},
       {"memory", "/bytes", mega}});
  for (const int wisps : sizes(options)) {
    for (const bool contacts : {false, true}) {
      for (const int threads : std::set<int>{1, options.threads}) {
        output.add(measure_row(registry, options, wisps, contacts, threads));
      }
    }
  }
}

}  // namespace ringlet
