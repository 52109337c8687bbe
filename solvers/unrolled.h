#pragma once

#include <type_traits>
#include <utility>

namespace ringlet {

/// Calls body(n) for the constants n = 0 .. count - 1. What the compiler unrolls by itself it
/// unrolls late: until then an array of packs is memory, which is read again at every use.
template <int count, class Body>
[[gnu::always_inline]] inline void unrolled(const Body& body) {
  [&]<int... n>(std::integer_sequence<int, n...>) __attribute__((always_inline)) {
    (body(std::integral_constant<int, n>()), ...);
  }
  (std::make_integer_sequence<int, count>());
}

}  // namespace ringlet
