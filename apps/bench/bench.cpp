#include "apps/bench/bench.h"

namespace ringlet {

std::vector<Bench> all_benches() {
  return {
      {"filters", "what each filter of the Hessian costs, and how many Newton iterations it takes",
       bench_filters},
      {"step", "a step of the hairball, from 500 to 8,000 wisps, stage by stage", bench_step},
      {"strand", "a step of the single strands of the paper", bench_strand},
      {"solvers", "linear solvers on one system of the hairball", bench_solvers}};
}

}  // namespace ringlet
