#include "apps/bench/bench.h"

namespace ringlet {

std::vector<Bench> all_benches() {
  return {{.name = "elements",
           .summary = "an element of each energy with each filter, in lanes and one by one",
           .run = bench_elements},
          {.name = "filters",
           .summary = "what each filter of the Hessian costs, and its Newton iterations",
           .run = bench_filters},
          {.name = "step",
           .summary = "a step of the hairball, from 500 to 8,000 wisps, stage by stage",
           .run = bench_step,
           .has_strands = true,
           .has_threads = true},
          {.name = "strand",
           .summary = "a step of the single strands of the paper",
           .run = bench_strand},
          {.name = "solvers",
           .summary = "linear solvers on one system of the hairball",
           .run = bench_solvers,
           .has_strands = true,
           .has_threads = true},
          {.name = "tolerance",
           .summary = "what the tolerance of the conjugate gradients costs and is worth",
           .run = bench_tolerance,
           .has_strands = true,
           .has_threads = true},
          {.name = "colliders",
           .summary = "finding what is near a head: a sphere, a mesh, a grid of distances",
           .run = bench_colliders,
           .has_strands = true,
           .has_threads = true},
          {.name = "limits",
           .summary = "multiply-adds and bandwidths of this machine, and the part that is reached",
           .run = bench_limits,
           .has_strands = true,
           .has_threads = true}};
}

}  // namespace ringlet
