#pragma once

#include <chrono>

#include "core/step_report.h"

namespace ringlet {

/// Tells how a run goes: one line that is rewritten on a terminal; log lines, at most one a second,
/// otherwise.
class Progress {
 public:
  /// Of the steps after `first`.
  Progress(int first, int steps, bool quiet);
  /// Ends the line on the terminal.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(int step, const StepReport& report);

 private:
  using Clock = std::chrono::steady_clock;

  int first_;
  int steps_;
  bool quiet_;
  bool terminal_;
  bool line_open_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_shown_;
};

}  // namespace ringlet
