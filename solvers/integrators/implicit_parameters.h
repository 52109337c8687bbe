#pragma once

#include "solvers/integrators/sleepers.h"
#include "solvers/newton.h"

namespace ringlet {

/// What every implicit integrator has: its time step, Newton's method, and who may sleep.
struct ImplicitParameters {
  double dt = 1.0 / 30;
  NewtonParameters newton;
  SleepParameters sleep;

  static Schema<ImplicitParameters> schema() {
    return Schema<ImplicitParameters>()
        .key("dt", &ImplicitParameters::dt, "s", positive(), "time step")
        .include(&ImplicitParameters::newton)
        .include(&ImplicitParameters::sleep);
  }
};

}  // namespace ringlet
