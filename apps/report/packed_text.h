#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace ringlet {

/// Bytes as text that stands in an HTML page: deflated (RFC 1950), then base64 (RFC 4648).
std::string pack_text(std::span<const std::uint8_t> bytes);

/// Numbers as they lie in memory.
template <class T>
std::string pack_numbers(const std::vector<T>& numbers) {
  return pack_text(
      {reinterpret_cast<const std::uint8_t*>(numbers.data()), numbers.size() * sizeof(T)});
}

}  // namespace ringlet
