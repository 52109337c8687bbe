// The linear solvers, each on the system of one and the same Newton iteration.

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
  std::vector<Json> measure(const std::string& name, LinearSolver& solver) {
    SystemMatrix matrix(model_.groups);
    VertexField gradient(model_.groups), solution(model_.groups);
    solver.bind(model_.groups);
    IncrementalPotential(model_, target_, dt_).assemble(x_, gradient, matrix, solver, solution);
    bool accepted = false;
    SolveReport report;
    const double prepare = seconds_of([&] { accepted = solver.prepare(matrix); });
    const double solve =
        seconds_of([&] { report = accepted ? solver.solve(gradient, solution) : SolveReport(); });
    return {name,           contacts(),        prepare,
            solve,          report.iterations, accepted && report.converged ? "yes" : "no",
            report.residual};
  }

 private:
  const Model& model_;
  VertexField x_, target_;
  double dt_;
};

}  // namespace

std::vector<BenchTable> bench_solvers(const Registry& registry, const BenchOptions& options) {
  BenchTable table{
      "Linear solvers on one Newton iteration of the hairball in its first lean, to "
      "1e-6; s, all threads; factors of strands are computed during evaluation",
      {"solver", "contacts", "prepare", "solve", "iterations", "converged", "residual"}};
  const auto pcg = [](const Json& preconditioner) {
    return Json{{"type", "pcg"}, {"max_iterations", 10000}, {"preconditioner", preconditioner}};
  };
  Simulation simulation(read_scene(hairball(options.quick() ? 16 : 2000), registry, "."));
  for (int step = 0; step < (options.quick() ? 1 : 50); ++step) simulation.step();
  NewtonSystem system(simulation, 1.0 / 30);
  for (const auto& [name, json] :
       {std::pair<std::string, Json>{"pcg, strand_cholesky", pcg("strand_cholesky")},
        {"pcg, jacobi", pcg("jacobi")},
        {"pcg, none", pcg(nullptr)},
        {"cholesky", "cholesky"}}) {
    table.rows.push_back(system.measure(name, *make_chosen<LinearSolver>(registry, json)));
  }
  return {table};
}

}  // namespace ringlet
