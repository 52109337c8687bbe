#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "core/collision_stage.h"

namespace ringlet {

/// Seconds spent in each stage of a step.
struct StageSeconds {
  double detect = 0;       ///< candidates for contacts are collected
  double couple = 0;       ///< contacts and couplings are measured and sorted for the matrix
  double evaluate = 0;     ///< energies and forces, and factors of strands
  double solve = 0;        ///< the linear solver
  double line_search = 0;  ///< values of the potential

  void operator+=(const StageSeconds& other) {
    detect += other.detect;
    couple += other.couple;
    evaluate += other.evaluate;
    solve += other.solve;
    line_search += other.line_search;
  }
};

/// What an integrator says about one step.
struct StepReport {
  /// Of strands that are solved separately, the most of any group; so are newton_update and
  /// line_search_halvings.
  int newton_iterations = 0;
  bool newton_converged = true;  ///< false: the iteration cap was hit first
  double newton_update = 0;      ///< largest vertex displacement of the last Newton update, m
  int linear_iterations = 0;     ///< of all solves of the step
  bool linear_converged = true;  ///< of all solves of the step
  double linear_residual = 0;    ///< worst of the step, as the solver reports it
  int line_search_halvings = 0;
  int substeps = 1;              ///< into which the step was divided
  double local_error = 0;        ///< estimated, of the substeps together, m; 0: not estimated
  bool local_error_met = true;   ///< false: it is larger than the integrator's tolerance
  std::vector<double> energies;  ///< of each elastic term, couplings last, at the end, J
  double contact_energy = 0;     ///< of contacts, at the end, J
  double kinetic_energy = 0;     ///< J
  ContactReport contacts;
  StageSeconds seconds;
  std::string failure;  ///< not empty: the step failed; what, where; the state is unchanged
};

/// Adds the time from its construction to its destruction to a stage.
class StageTimer {
 public:
  explicit StageTimer(double& seconds) : seconds_(seconds), start_(Clock::now()) {}
  ~StageTimer() { seconds_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  double& seconds_;
  Clock::time_point start_;
};

}  // namespace ringlet
