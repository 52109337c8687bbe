#pragma once

#include <cstddef>
#include <vector>

namespace ringlet {

/// The memory that a vector holds, bytes.
template <class T, class Allocator>
std::size_t bytes_of(const std::vector<T, Allocator>& values) {
  return values.capacity() * sizeof(T);
}

/// That of a vector of vectors.
template <class T>
std::size_t bytes_of(const std::vector<std::vector<T>>& values) {
  std::size_t sum = values.capacity() * sizeof(std::vector<T>);
  for (const std::vector<T>& inner : values) sum += bytes_of(inner);
  return sum;
}

}  // namespace ringlet
