// The linear solvers, each on the system of one and the same Newton iteration.

#include <spdlog/fmt/fmt.h>

#include "apps/bench/bench.h"
#include "apps/bench/hairball.h"
#include "apps/bench/timing.h"
#include "core/incremental_potential.h"
#include "core/read_choice.h"

namespace ringlet {
namespace {

/// Of one call, s.
double seconds_of(const std::function<void()>& function) { return measure(function, 0).median; }

/// The first Newton iteration of the next step of a simulation.
class NewtonSystem {
 public:
  explicit NewtonSystem(const Simulation& simulation, double dt)
      : model_(simulation.model()), x_(simulation.state().positions), target_(x_), dt_(dt) {
    add_scaled(target_, dt, simulation.state().velocities);
    place_pins(model_, simulation.state().time + dt, x_);
    model_.collision->begin_step(simulation.state().positions, simulation.state().time + dt, dt);
    model_.collision->detect(x_);
    for (const auto& force : model_.forces) {
      force->begin_step({simulation.state(), dt, model_.energies});
    }
  }

  int contacts() const {
    const ContactReport report = model_.collision->report();
    return report.strand_contacts + report.collider_contacts;
  }
  BenchRow measure(const std::string& name, LinearSolver& solver) {
    SystemMatrix matrix(model_.groups);
    VertexField gradient(model_.groups), solution(model_.groups);
    solver.bind(model_.groups);
    IncrementalPotential(model_, target_, dt_).assemble(x_, gradient, matrix, solver, solution);
    bool accepted = false;
    SolveReport report;
    const double prepare = seconds_of([&] { accepted = solver.prepare(matrix); });
    const double solve =
        seconds_of([&] { report = accepted ? solver.solve(gradient, solution) : SolveReport(); });
    return {.name = "solvers",
            .parameters = {{"solver", name}},
            .stages = {{"prepare", prepare}, {"solve", solve}},
            .iterations = report.iterations,
            .contacts = contacts(),
            .figures = {{"converged", accepted && report.converged ? "yes" : "no"},
                        {"residual", report.residual}}};
  }

 private:
  const Model& model_;
  VertexField x_, target_;
  double dt_;
};

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
       {"iterations", "/iterations"},
       {"converged", "/figures/converged"},
       {"residual", "/figures/residual"}});
  const auto pcg = [](const Json& preconditioner) {
    return Json{{"type", "pcg"}, {"max_iterations", 10000}, {"preconditioner", preconditioner}};
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
      output.add(system.measure(name, *make_chosen<LinearSolver>(registry, json)));
    }
  });
}

}  // namespace ringlet
