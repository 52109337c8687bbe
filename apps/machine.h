#pragma once

#include <cstdint>

#include "core/parameters.h"

namespace ringlet {

/// The most memory that this process has used so far.
std::int64_t peak_memory_bytes();

/// What results were computed with: processor, threads, version, compiler, build type.
Json describe_machine();

}  // namespace ringlet
