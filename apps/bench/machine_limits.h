#pragma once

#include "apps/bench/timing.h"

namespace ringlet {

/// What a machine can do at best, each measured by a loop that does nothing else, on so many
/// threads at once.
struct Rate {
  double value;  ///< a second
  Timing time;   ///< of one measurement
};

/// Fused multiply-adds in registers, two operations each.
Rate multiply_add_rate(int threads, double seconds);
/// Bytes of y += s x, which reads two arrays and writes one, far larger than any cache.
Rate memory_rate(int threads, double seconds);
/// The same within 256 KB a thread, which the second-level cache holds.
Rate cache_rate(int threads, double seconds);

}  // namespace ringlet
