#include "apps/bench/peak_memory.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <fstream>

#include "apps/machine.h"

namespace ringlet {
namespace {

/// proc(5): writing 5 resets the peak of the resident set.
bool reset_peak() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
  std::ofstream file("/proc/self/clear_refs");
  file << 5 << std::flush;
  return file.good();
}

}  // namespace

std::optional<std::int64_t> peak_memory_during(const std::function<void()>& function) {
  const bool was_reset = reset_peak();
  function();
  if (!was_reset) return std::nullopt;
  return peak_memory_bytes();
}

}  // namespace ringlet
