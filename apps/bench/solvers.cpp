// The linear solvers, each on the system of one and the same Newton iteration.

#include <spdlog/fmt/fmt.h>

#include "apps/bench/bench.h"
#include "apps/bench/hairball.h"
#include "apps/bench/newton_system.h"
#include "core/read_choice.h"

namespace ringlet {
namespace {

/// Once where that takes longer than so many seconds.
Timing measure_once_or_more(const std::function<void()>& function, double seconds) {
  const Timing once = measure(function, 0);
  return once.median < seconds ? measure(function, seconds) : once;
}

BenchRow measure_solver(const NewtonSystem& system, const std::string& name, LinearSolver& solver,
                        double seconds) {
  const StrandGroups& groups = system.model().groups;
  SystemMatrix matrix(groups);
  VertexField gradient(groups), solution(groups);
  solver.bind(groups);
  system.assemble(solver, matrix, gradient, solution);
  bool accepted = false;
  SolveReport report;
  const Timing prepare = measure_once_or_more([&] { accepted = solver.prepare(matrix); }, seconds);
  const Timing solve = measure_once_or_more(
      [&] { report = accepted ? solver.solve(gradient, solution) : SolveReport(); }, seconds);
  return {.name = "solvers",
          .parameters = {{"solver", name}},
          .time = Timing{prepare.median + solve.median, prepare.spread + solve.spread},
          .stages = {{"prepare", prepare.median}, {"solve", solve.median}},
          .iterations = report.iterations,
          .contacts = system.contacts(),
          .figures = {{"converged", accepted && report.converged ? "yes" : "no"},
                      {"residual", report.residual}}};
}

}  // namespace

void bench_solvers(const Registry& registry, const BenchOptions& options, BenchOutput& output) {
  const int wisps = options.strands_or(2000);
  output.start_table(
      fmt::format("Linear solvers on one Newton iteration of the hairball of {} wisps in its first "
                  "lean, to 1e-6; s, {} threads; factors of strands are computed during evaluation",
                  wisps, options.threads),
      {{"solver", "/parameters/solver"},
       {"contacts", "/contacts"},
       {"prepare", "/stages/prepare"},
       {"solve", "/stages/solve"},
       {"spread of both", "/spread"},
       {"iterations", "/iterations"},
       {"converged", "/figures/converged"},
       {"residual", "/figures/residual"}});
  const auto pcg = [](const Json& preconditioner) {
    return Json{{"type", "pcg"},
                {"tolerance", 1e-6},
                {"max_iterations", 10000},
                {"preconditioner", preconditioner}};
  };
  with_threads(options.threads, [&] {
    Simulation simulation(read_scene(hairball(wisps), registry, "."));
    skip_steps(simulation, options.quick() ? 1 : 50);
    NewtonSystem system(simulation, 1.0 / 30);
    for (const auto& [name, json] :
         {std::pair<std::string, Json>{"pcg, strand_cholesky", pcg("strand_cholesky")},
          {"pcg, jacobi", pcg("jacobi")},
          {"pcg, none", pcg(nullptr)},
          {"cholesky", "cholesky"}}) {
      output.add(measure_solver(system, name, *make_chosen<LinearSolver>(registry, json),
                                options.seconds));
    }
  });
}

}  // namespace ringlet
