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
  /// Instead of begin(): the run goes on after a step, from which folder holds what an earlier run
  /// left, perhaps a killed one. What is there of later steps, and what end() wrote beyond what
  /// observe() would have, must go, so that in the end all is as of a run without a break. Throws
  /// Error, also where a writer has no such thing.
  virtual void resume(const Model&, const State&, const std::filesystem::path&, int /*step*/) {
    throw Error("it cannot go on with what an earlier run wrote");
  }
  /// After each step that did not fail; step counts from 1.
  virtual void observe(const Model& model, const State& state, int step,
                       const StepReport& report) = 0;
  /// After the last step, also of an interrupted or failed run: the state after `step` is the last
  /// good one, and what an observer skipped of it so far it must write now.
  virtual void end(const Model& model, const State& state, int step) = 0;
};

}  // namespace ringlet
