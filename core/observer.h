#pragma once

#include <filesystem>

#include "core/model.h"
#include "core/named.h"
#include "core/step_report.h"

namespace ringlet {

/// Sees every new state. Writers of files are observers.
class Observer : public Named {
 public:
  virtual ~Observer() = default;
  /// Before the first step, step 0. Writes, if at all, below the run folder. Throws Error if it
  /// cannot, as the others do.
  virtual void begin(const Model& model, const State& state,
                     const std::filesystem::path& folder) = 0;
  /// After each step that did not fail; step counts from 1.
  virtual void observe(const Model& model, const State& state, int step,
                       const StepReport& report) = 0;
  /// After the last step, also of an interrupted or failed run: the state after `step` is the last
  /// good one, and what an observer skipped of it so far it must write now.
  virtual void end(const Model& model, const State& state, int step) = 0;
};

}  // namespace ringlet
