#pragma once

#include "apps/bench/bench.h"
#include "core/verify/verify_energy.h"

namespace ringlet {

/// Time that an element takes with gradient and Hessian, on one thread; strands are curls of the
/// paper's shape, deformed. The derivatives of all groups go to the same place, as where a group is
/// factored once it is evaluated.
Timing time_element(const EnergyMaker& make, const Json& keys, const BenchOptions& options);

}  // namespace ringlet
