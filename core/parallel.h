#pragma once

#include <tbb/parallel_for.h>

#include <numeric>
#include <vector>

#include "core/fork_join.h"

namespace ringlet {

/// body(i) for all i in [0, count), in parallel. Iterations must not write to shared memory.
template <class Body>
void parallel_for_each(int count, const Body& body) {
  if (count == 1) {
    body(0);
  } else {
    const ForkJoin loop;
    tbb::parallel_for(0, count, [&](int i) {
      loop.begin_part();
      body(i);
      loop.end_part();
    });
  }
}

/// The sum of body(i) over [0, count): computed in parallel, added in order, so that the bits of
/// the result do not depend on the number of threads.
template <class Body>
double parallel_sum(int count, const Body& body) {
  if (count == 1) return body(0);
  std::vector<double> terms(count);
  parallel_for_each(count, [&](int i) { terms[i] = body(i); });
  return std::accumulate(terms.begin(), terms.end(), 0.0);
}

}  // namespace ringlet
