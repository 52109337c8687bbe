#include "apps/interrupt.h"

#include <atomic>

namespace ringlet {
namespace {

// A signal handler can reach nothing but a global.
constinit std::atomic<bool> signalled = false;
static_assert(std::atomic<bool>::is_always_lock_free);

void remember(int) { signalled = true; }

}  // namespace

Interrupt::Interrupt() {
  signalled = false;
  struct sigaction action {};
  action.sa_handler = remember;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, &old_interrupt_);
  sigaction(SIGTERM, &action, &old_terminate_);
}

Interrupt::~Interrupt() {
  sigaction(SIGINT, &old_interrupt_, nullptr);
  sigaction(SIGTERM, &old_terminate_, nullptr);
}

bool Interrupt::requested() const { return signalled; }

}  // namespace ringlet
