#include "apps/study/study_progress.h"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <cstdio>

namespace ringlet {
namespace {

constexpr int bar_width = 24;

std::string bar(double part) {
  const auto full = static_cast<std::size_t>(part * bar_width);
  return "[" + std::string(full, '#') + std::string(bar_width - full, '.') + "]";
}

}  // namespace

StudyProgress::StudyProgress(int variants, bool quiet)
    : variants_(variants), quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {}

StudyProgress::~StudyProgress() {
  if (line_open_) std::fputs("\n", stderr);
}

void StudyProgress::start(const std::string& name) {
  const std::lock_guard lock(mutex_);
  show(name);
}

void StudyProgress::end(const std::string& name) {
  const std::lock_guard lock(mutex_);
  ++done_;
  if (terminal_) show(name);
}

void StudyProgress::show(const std::string& what) {
  if (quiet_) return;
  const double passed = std::chrono::duration<double>(Clock::now() - start_).count();
  const std::string left =
      done_ > 0 ? fmt::format("  about {:.0f} s left", passed / done_ * (variants_ - done_)) : "";
  const std::string text = fmt::format(
      "{} {}/{}{}  {}", bar(static_cast<double>(done_) / variants_), done_, variants_, left, what);
  if (terminal_) {
    fmt::print(stderr, "\r\033[K{}", text);
    std::fflush(stderr);
    line_open_ = true;
  } else {
    spdlog::info(text);
  }
}

}  // namespace ringlet
