#include "apps/bench/bench.h"

namespace ringlet {

const std::vector<Bench>& all_benches() {
  static const std::vector<Bench> benches{
      {"filters", "what each filter of the Hessian costs, and how many Newton iterations it takes",
       bench_filters}};
  return benches;
}

}  // namespace ringlet
