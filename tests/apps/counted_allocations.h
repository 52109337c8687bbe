#pragma once

namespace ringlet {

/// How often this program has asked for memory with new, in all threads.
long allocation_count();

}  // namespace ringlet
