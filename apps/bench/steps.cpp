// How long a time step takes: the hairball, stage by stage, and the single strands of the paper.

#include "apps/bench/bench.h"
#include "apps/bench/hairball.h"

namespace ringlet {
namespace {

constexpr double milli = 1e-3;

std::vector<Json> row(int wisps, const char* contacts, int threads, const StepFigures& figures) {
  return {wisps,
          contacts,
          threads,
          figures.step.median / milli,
          figures.step.spread / milli,
          figures.stages.detect / milli,
          figures.stages.evaluate / milli,
          figures.stages.solve / milli,
          figures.stages.line_search / milli,
          figures.newton_iterations,
          figures.linear_iterations,
          figures.contacts};
}

}  // namespace

std::vector<BenchTable> bench_step(const Registry& registry, const BenchOptions& options) {
  BenchTable table{
      "Hairball, a step in ms: without contacts 3 Newton iterations, steps 6 to 20; with contacts "
      "to the default tolerances, steps 46 to 60, which lie in the first lean",
      {"wisps", "contacts", "threads", "step", "spread", "detect", "evaluate and factor", "solve",
       "line search", "Newton iterations", "CG iterations", "contacts found"}};
  const std::vector<int> sizes =
      options.quick() ? std::vector<int>{16} : std::vector<int>{500, 1000, 2000, 4000, 8000};
  for (const int wisps : sizes) {
    for (const int threads : {1, 2}) {
      with_threads(threads, [&] {
        const auto free = hairball_without_contacts(wisps);
        table.rows.push_back(row(wisps, "off", threads,
                                 options.quick() ? measure_steps(registry, free, 1, 1)
                                                 : measure_steps(registry, free, 6, 20)));
        const auto touching = hairball(wisps);
        table.rows.push_back(row(wisps, "on", threads,
                                 options.quick() ? measure_steps(registry, touching, 1, 1)
                                                 : measure_steps(registry, touching, 46, 60)));
      });
    }
  }
  return {table};
}

std::vector<BenchTable> bench_strand(const Registry& registry, const BenchOptions& options) {
  struct PaperFigure {
    const char* scene;
    double seconds;
  };
  BenchTable table{
      "One strand, 3 Newton iterations a step on one thread, steps 2 to 30, ms; beside "
      "the paper's table 2 (another machine)",
      {"scene", "step", "spread", "evaluate and factor", "line search", "paper",
       "paper takes x times as long"}};
  for (const auto& [scene, paper] : {PaperFigure{"smash", 7.5e-3}, PaperFigure{"jitter", 7.5e-3},
                                     PaperFigure{"straighten", 3.9e-3}}) {
    Json json = bundled_scene(scene);
    json["integrator"]["newton_tolerance"] = 0;
    with_threads(1, [&, name = scene, paper_seconds = paper] {
      const StepFigures figures = measure_steps(registry, json, 2, options.quick() ? 3 : 30);
      table.rows.push_back({name, figures.step.median / milli, figures.step.spread / milli,
                            figures.stages.evaluate / milli, figures.stages.line_search / milli,
                            paper_seconds / milli, paper_seconds / figures.step.median});
    });
  }
  return {table};
}

}  // namespace ringlet
