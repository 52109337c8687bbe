// What the tolerance of the conjugate gradients costs and what it is worth: the error in positions
// after sixty steps of the hairball against a tight solve.

#include <spdlog/fmt/fmt.h>

#include "apps/bench/bench.h"
#include "apps/bench/hairball.h"

namespace ringlet {
namespace {

struct Outcome {
  StepFigures figures;
  Eigen::Matrix3Xd positions;
};

Outcome run_hairball(const Registry& registry, const BenchOptions& options, double tolerance) {
  const auto [skipped, steps] = options.quick() ? std::pair(0, 2) : std::pair(45, 15);
  Json scene = hairball(options.strands_or(2000));
  scene["solver"]["tolerance"] = tolerance;
  Simulation simulation(read_scene(scene, registry, "."));
  skip_steps(simulation, skipped);
  const StepFigures figures = measure_steps(simulation, steps);
  return {figures, simulation.state().positions.matrix()};
}

/// Of the strands of the hairball, which are all of one length, m.
double strand_length(const Registry& registry) {
  const Simulation simulation(read_scene(hairball(1), registry, "."));
  const Strands& strands = simulation.model().strands;
  double length = 0;
  for (int v = 1; v < strands.vertex_count(); ++v) {
    length += (strands.rest_position(v) - strands.rest_position(v - 1)).norm();
  }
  return length;
}

}  // namespace

void bench_tolerance(const Registry& registry, const BenchOptions& options, BenchOutput& output) {
  constexpr double milli = 1e-3, percent = 1e-2, tight = 1e-10;
  output.start_table(
      fmt::format(
          "Tolerance of the conjugate gradients: steps 46 to 60 of the hairball of {} wisps, "
          "{} threads; distance of vertices after step 60 from where a tolerance of {:g} "
          "takes them, % of the length of a strand",
          options.strands_or(2000), options.threads, tight),
      {{"tolerance", "/parameters/tolerance"},
       {"step, ms", "/seconds", milli},
       {"spread", "/spread", milli},
       {"solve, ms", "/stages/solve", milli},
       {"CG iterations", "/iterations"},
       {"contacts", "/contacts"},
       {"largest error, %", "/figures/largest_error", percent},
       {"mean error, %", "/figures/mean_error", percent}});
  with_threads(options.threads, [&] {
    const double length = strand_length(registry);
    const Outcome exact = run_hairball(registry, options, tight);
    for (const double tolerance : {1e-1, 3e-2, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8, tight}) {
      const Outcome outcome =
          tolerance == tight ? exact : run_hairball(registry, options, tolerance);
      const Eigen::VectorXd errors =
          (outcome.positions - exact.positions).colwise().norm() / length;
      output.add(
          {.name = "tolerance",
           .parameters = {{"tolerance", tolerance}, {"threads", options.threads}},
           .time = outcome.figures.step,
           .stages = as_json(outcome.figures.stages),
           .iterations = outcome.figures.linear_iterations,
           .contacts = outcome.figures.contacts,
           .figures = {{"largest_error", errors.maxCoeff()}, {"mean_error", errors.mean()}}});
    }
  });
}

}  // namespace ringlet
