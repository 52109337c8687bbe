#include "apps/progress.h"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <cstdio>

namespace ringlet {
namespace {

std::string clock_text(double seconds) {
  const int whole = static_cast<int>(seconds + 0.5);
  return whole < 3600 ? fmt::format("{}:{:02}", whole / 60, whole % 60)
                      : fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace

Progress::Progress(int first, int steps, bool quiet)
    : first_(first), steps_(steps), quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (line_open_) std::fputs("\n", stderr);
}

void Progress::show(int step, const StepReport& report) {
  if (quiet_) return;
  const Clock::time_point now = Clock::now();
  const auto pause = terminal_ ? std::chrono::milliseconds(100) : std::chrono::milliseconds(1000);
  if (step < steps_ && now - last_shown_ < pause) return;
  last_shown_ = now;
  const int done = step - first_;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const std::string text = fmt::format(
      "step {}/{}  {:.3g} steps/s  {:.3g} ms/step  left {}  contacts {}  newton {}", step, steps_,
      done / seconds, 1e3 * seconds / done, clock_text(seconds / done * (steps_ - step)),
      report.contacts.strand_contacts + report.contacts.collider_contacts,
      report.newton_iterations);
  if (terminal_) {
    // Erases the old line first; a message of the log that comes between stays readable.
    fmt::print(stderr, "\r\033[K{}", text);
    std::fflush(stderr);
    line_open_ = true;
  } else {
    spdlog::info(text);
  }
}

}  // namespace ringlet
