#pragma once

#include <string>
#include <vector>

#include "apps/expectations.h"
#include "core/module_costs.h"
#include "core/parameters.h"
#include "core/simulation.h"

namespace ringlet {

/// What is known of a run at its end: the content of summary.json.
struct RunRecord {
  std::string scene;
  int steps_wanted = 0;
  int steps = 0;            ///< that were done
  double wall_seconds = 0;  ///< of the steps and of what was written of them
  double step_seconds = 0;  ///< of the steps alone
  StageSeconds seconds;
  int newton_caps = 0;  ///< steps in which Newton's method hit its cap
  int linear_caps = 0;  ///< steps in which a linear solve hit its cap
  int error_caps = 0;   ///< steps whose local error was larger than the integrator's tolerance
  bool interrupted = false;
  std::string failure;  ///< not empty: the run failed
  std::vector<ExpectationResult> expectations;
  std::vector<ModuleCost> modules;  ///< of the simulation, then of the writers

  void add(const StepReport& report, double seconds);
  bool met_expectations() const;
};

/// The record as summary.json, with size and memory of the simulation and what it ran on.
Json summarise(const RunRecord& record, const Simulation& simulation);

}  // namespace ringlet
