#pragma once

#include "solvers/newton.h"

namespace ringlet {

/// What every implicit integrator has: its time step, and Newton's method.
struct ImplicitParameters {
  double dt = 1.0 / 30;
  NewtonParameters newton;

  static Schema<ImplicitParameters> schema() {
    return Schema<ImplicitParameters>()
        .key("dt", &ImplicitParameters::dt, "s", positive(), "time step")
        .include(&ImplicitParameters::newton);
  }
};

}  // namespace ringlet
