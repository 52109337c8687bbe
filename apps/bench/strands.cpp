// How long a time step of the single strands of the paper takes.

#include "apps/bench/bench.h"
#include "apps/bench/hairball.h"

namespace ringlet {

void bench_strand(const Registry& registry, const BenchOptions& options, BenchOutput& output) {
  struct PaperFigure {
    const char* scene;
    double seconds;
  };
  constexpr double milli = 1e-3;
  output.start_table(
      "One strand, 3 Newton iterations a step on one thread, steps 2 to 30, ms; beside "
      "the paper's table 2 (another machine)",
      {{"scene", "/parameters/scene"},
       {"step", "/seconds", milli},
       {"spread", "/spread", milli},
       {"evaluate and factor", "/stages/evaluate", milli},
       {"line search", "/stages/line_search", milli},
       {"paper", "/figures/paper_seconds", milli},
       {"paper takes x times as long", "/figures/paper_ratio"}});
  for (const auto& [scene, paper] : {PaperFigure{"smash", 7.5e-3}, PaperFigure{"jitter", 7.5e-3},
                                     PaperFigure{"straighten", 3.9e-3}}) {
    Json json = bundled_scene(scene);
    json["integrator"]["newton_tolerance"] = 0;
    StepFigures figures;
    with_threads(1, [&] {
      Simulation simulation(read_scene(json, registry, "."));
      skip_steps(simulation, 1);
      figures = measure_steps(simulation, options.quick() ? 2 : 29);
    });
    output.add({.name = "strand",
                .parameters = {{"scene", scene}, {"threads", 1}},
                .time = figures.step,
                .stages = as_json(figures.stages),
                .figures = {{"newton_iterations", figures.newton_iterations},
                            {"paper_seconds", paper},
                            {"paper_ratio", paper / figures.step.median}}});
  }
}

}  // namespace ringlet
