#pragma once

#ifdef __SANITIZE_THREAD__
#include <sanitizer/tsan_interface.h>
#endif

namespace ringlet {

/// Tells the thread sanitizer what orders a parallel loop: its parts begin after what came before
/// the loop, and end before what comes after it. TBB is not built with the sanitizer, which so
/// cannot see this and would take every result of a loop for a data race. Two parts of a loop stay
/// unordered: a race between them is found. Without the sanitizer (g++) nothing of this exists.
class ForkJoin {
 public:
#ifdef __SANITIZE_THREAD__
  ForkJoin() { __tsan_release(&fork_); }
  ~ForkJoin() { __tsan_acquire(&join_); }
  void begin_part() const { __tsan_acquire(&fork_); }
  void end_part() const { __tsan_release(&join_); }

 private:
  mutable char fork_ = 0, join_ = 0;
#else
  void begin_part() const {}
  void end_part() const {}
#endif
};

}  // namespace ringlet
