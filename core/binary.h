#pragma once

#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/error.h"

namespace ringlet {

/// Appends a value as the machine holds it.
template <class T>
void append_bytes(std::string& bytes, const T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// Takes values from bytes, one after the other.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  std::size_t left() const { return bytes_.size(); }
  /// Throws Error if there are not so many left.
  std::string_view take_bytes(std::size_t count) {
    if (count > left()) throw Error("it ends too early");
    const std::string_view taken = bytes_.substr(0, count);
    bytes_.remove_prefix(count);
    return taken;
  }
  template <class T>
  T take() {
    static_assert(std::is_trivially_copyable_v<T>);
    T value;
    std::memcpy(&value, take_bytes(sizeof value).data(), sizeof value);
    return value;
  }

 private:
  std::string_view bytes_;
};

}  // namespace ringlet
