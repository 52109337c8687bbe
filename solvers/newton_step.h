#pragma once

#include "core/incremental_potential.h"
#include "core/step_report.h"

namespace ringlet {

/// What Newton's method works on in one step.
struct NewtonStep {
  Model& model;
  IncrementalPotential& potential;
  SystemMatrix& matrix;
  double dt;           ///< s
  StepReport& report;  ///< gets the figures of the linear solver, and the seconds of the stages
};

}  // namespace ringlet
