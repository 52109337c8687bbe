// What this machine can do at best, and how much of it evaluation, factorisation and substitution
// of a group of strands reach.

#include <set>

#include "apps/bench/bench.h"
#include "apps/bench/hairball.h"
#include "apps/bench/machine_limits.h"
#include "apps/bench/newton_system.h"
#include "core/read_choice.h"

namespace ringlet {
namespace {

/// What something does, a vertex.
struct Cost {
  double operations, memory_bytes, cache_bytes;
};

/// Operations of the energies are counted by running their kernels with a counting scalar; all
/// others follow from the formulas.
Cost cost_of_vertex(const Model& model) {
  // core/incremental_potential.cpp: inertia 10, its gradient 16, gravity 13, pins 9, mass in the
  // Hessian 6; core/edge_derivatives.cpp: blocks of edges to those of vertices 18 + 27 + 18.
  constexpr double assembly = 10 + 16 + 13 + 9 + 6 + 18 + 27 + 18;
  // solvers/band_cholesky.cpp, three blocks left of the diagonal: three products of blocks, three
  // with a triangle, three squares of which a triangle is kept, one factor of a block.
  constexpr double factorisation = 3 * 54 + 3 * 27 + 3 * 36 + 55;
  // Forth and back: three blocks times a vector, and a triangle times a vector.
  constexpr double substitution = 2 * (3 * 18 + 9);
  Cost cost{assembly + factorisation + substitution, 0, 0};

  constexpr double vector = 3 * sizeof(double), block = 9 * sizeof(double);
  // Position, target, mass (also by gravity) and pins are read; gradient and solution fetched and
  // written.
  cost.memory_bytes = 2 * vector + 3 * sizeof(double) + 2 * 2 * vector;
  // The bands are written, read and written by the factorisation, read twice by the substitution.
  cost.cache_bytes = 5 * band_blocks * block;

  const Strands& strands = model.strands;
  for (const auto& energy : model.energies) {
    const ElementFunction& element = *energy->element_function();
    Eigen::Matrix3Xd x(3, element.vertices());
    for (int n = 0; n < x.cols(); ++n) x.col(n) = strands.rest_position(strands.first(0) + n);
    const ElementCost one = element.cost(x, 1, 1);
    const double elements = strands.size(0) - element.vertices() + 1;
    cost.operations += double(one.operations) * elements / strands.size(0);
    cost.memory_bytes += one.rest_bytes;
  }
  return cost;
}

struct Peaks {
  double multiply_adds, memory, cache;
};

BenchRow rate_row(const char* name, int threads, const char* what, const Rate& rate) {
  return {.name = std::string("limits/") + name,
          .parameters = {{"threads", threads}},
          .time = rate.time,
          .figures = {{what, rate.value}}};
}

Peaks measure_peaks(int threads, const BenchOptions& options, BenchOutput& output) {
  const Rate multiply_adds = multiply_add_rate(threads, options.seconds);
  output.add(rate_row("multiply_add", threads, "operations_a_second", multiply_adds));
  const Rate memory = memory_rate(threads, options.seconds);
  output.add(rate_row("memory", threads, "memory_bytes_a_second", memory));
  const Rate cache = cache_rate(threads, options.seconds);
  output.add(rate_row("cache", threads, "cache_bytes_a_second", cache));
  return {multiply_adds.value, memory.value, cache.value};
}

BenchRow measure_evaluation(const Registry& registry, const NewtonSystem& system, int threads,
                            const Peaks& peaks, double seconds) {
  const StrandGroups& groups = system.model().groups;
  const auto solver = make_chosen<LinearSolver>(registry, "strand_cholesky");
  solver->bind(groups);
  SystemMatrix matrix(groups);
  VertexField gradient(groups), solution(groups);
  Timing time{};
  with_threads(threads, [&] {
    time = measure([&] { system.assemble(*solver, matrix, gradient, solution); }, seconds);
  });
  const Cost cost = cost_of_vertex(system.model());
  const double vertices = groups.vertex_count() / time.median;  // a second
  return {.name = "limits/evaluate_factor_substitute",
          .parameters = {{"threads", threads}},
          .time = time,
          .figures = {{"operations_a_vertex", cost.operations},
                      {"operations_a_second", cost.operations * vertices},
                      {"memory_bytes_a_second", cost.memory_bytes * vertices},
                      {"cache_bytes_a_second", cost.cache_bytes * vertices},
                      {"part_of_multiply_add", cost.operations * vertices / peaks.multiply_adds},
                      {"part_of_memory", cost.memory_bytes * vertices / peaks.memory},
                      {"part_of_cache", cost.cache_bytes * vertices / peaks.cache}}};
}

}  // namespace

void bench_limits(const Registry& registry, const BenchOptions& options, BenchOutput& output) {
  constexpr double milli = 1e-3, giga = 1e9, percent = 1e-2;
  output.start_table(
      "Limits of this machine (multiply-adds of two operations in registers; y += s x in memory "
      "and within 256 KB a thread), and what evaluation with factorisation and substitution "
      "reaches: "
      "the hairball without contacts, one Newton iteration",
      {{"what", "/name"},
       {"threads", "/parameters/threads"},
       {"ms", "/seconds", milli},
       {"spread", "/spread", milli},
       {"10^9 operations/s", "/figures/operations_a_second", giga},
       {"GB/s of memory", "/figures/memory_bytes_a_second", giga},
       {"GB/s of cache", "/figures/cache_bytes_a_second", giga},
       {"% of multiply-adds", "/figures/part_of_multiply_add", percent},
       {"% of memory", "/figures/part_of_memory", percent},
       {"% of cache", "/figures/part_of_cache", percent}});
  const Json scene = hairball_without_contacts(options.strands_or(2000));
  Simulation simulation(read_scene(scene, registry, "."));
  skip_steps(simulation, options.quick() ? 1 : 5);
  const NewtonSystem system(simulation, scene["integrator"]["dt"].get<double>());
  for (const int threads : std::set<int>{1, options.threads}) {
    const Peaks peaks = measure_peaks(threads, options, output);
    output.add(measure_evaluation(registry, system, threads, peaks, options.seconds));
  }
}

}  // namespace ringlet
