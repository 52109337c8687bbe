#include "apps/machine.h"

#include <sys/resource.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <fstream>
#include <string>

#include "apps/build_info.h"

namespace ringlet {
namespace {

// The arena of the main thread may be older than the limit that --threads sets.
std::size_t thread_count() {
  const std::size_t limit =
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  return std::min<std::size_t>(limit, tbb::this_task_arena::max_concurrency());
}

/// As Linux calls it; "" elsewhere.
std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  const std::string key = "model name";
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with(key) && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "";
}

}  // namespace

std::int64_t peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return std::int64_t{usage.ru_maxrss} * 1024;
}

Json describe_machine() {
  return {{"processor", processor_name()},
          {"threads", thread_count()},
          {"version", build_info::version},
          {"compiler", build_info::compiler},
          {"build_type", build_info::build_type}};
}

}  // namespace ringlet
