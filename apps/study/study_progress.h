#pragma once

#include <chrono>
#include <mutex>
#include <string>

namespace ringlet {

/// Tells how a study goes: a line that is rewritten on a terminal, else a line a variant.
class StudyProgress {
 public:
  StudyProgress(int variants, bool quiet);
  /// Ends the line on the terminal.
  ~StudyProgress();
  StudyProgress(const StudyProgress&) = delete;
  StudyProgress& operator=(const StudyProgress&) = delete;

  /// A variant starts, or ends. From any thread.
  void start(const std::string& name);
  void end(const std::string& name);

 private:
  using Clock = std::chrono::steady_clock;
  void show(const std::string& what);

  int variants_;
  bool quiet_;
  bool terminal_;
  std::mutex mutex_;
  int done_ = 0;
  bool line_open_ = false;
  Clock::time_point start_ = Clock::now();
};

}  // namespace ringlet
