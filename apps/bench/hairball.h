#pragma once

#include <functional>

#include "apps/bench/timing.h"
#include "core/simulation.h"

namespace ringlet {

/// The hairball of Lifted Curls with that many wisps, as the paper scales it: radii by
/// sqrt(2000/N), half the thickness for 8,000; every pair within the thickness pushes, as there;
/// nothing is written.
Json hairball(int wisps);
/// Without collision, three Newton iterations in every step.
Json hairball_without_contacts(int wisps);

/// Calls the function with that many threads at most.
void with_threads(int threads, const std::function<void()>& function);

/// Medians over steps of a simulation.
struct StepFigures {
  Timing step;  ///< of a whole step
  StageSeconds stages;
  double newton_iterations = 0, linear_iterations = 0, contacts = 0;
};

/// {"detect", "couple", "evaluate", "solve", "line_search"}, s.
Json as_json(const StageSeconds& stages);

/// Takes so many steps. Throws Error if one of them fails.
void skip_steps(Simulation& simulation, int count);
/// Measures so many steps. Throws Error if one of them fails.
StepFigures measure_steps(Simulation& simulation, int count);

}  // namespace ringlet
