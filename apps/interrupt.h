#pragma once

#include <csignal>

namespace ringlet {

/// While it lives, the first SIGINT (Ctrl-C) or SIGTERM is only remembered, so that a run can end
/// after its current step; the second one kills as usual. At most one may live at a time.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  bool requested() const;

 private:
  struct sigaction old_interrupt_, old_terminate_;
};

}  // namespace ringlet
