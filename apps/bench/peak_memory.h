#pragma once

#include <cstdint>
#include <functional>
#include <optional>

namespace ringlet {

/// The most memory that this process has in use while it calls the function, bytes, what it holds
/// already included. Freed memory is given back to the system before. Nothing where the system does
/// not let its record be reset (Linux: /proc/self/clear_refs).
std::optional<std::int64_t> peak_memory_during(const std::function<void()>& function);

}  // namespace ringlet
