#pragma once

#include <cstring>
#include <string>
#include <vector>

#include "core/strand_reader.h"
#include "tests/catch.h"
#include "tests/core/read_plugin.h"
#include "tests/temporary_file.h"

namespace ringlet {

/// The bytes of a number in this machine's order, which the readers require to be little endian.
template <class T>
std::string bytes_of(T value) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  return bytes;
}

inline std::string bytes_of_points(const std::vector<float>& coordinates) {
  std::string bytes;
  for (const float x : coordinates) bytes += bytes_of(x);
  return bytes;
}

/// What the reader of an extension makes of some bytes.
inline Polylines read_as(const std::string& extension, const std::string& bytes) {
  const TemporaryFile file(extension, bytes);
  return make_plugin<StrandReader>(extension)->read(file.path());
}

/// The message of the Error with which some bytes are refused; "" if they are read.
inline std::string refusal(const std::string& extension, const std::string& bytes) {
  try {
    const Polylines polylines = read_as(extension, bytes);
    std::size_t vertices = 0;
    for (const int count : polylines.vertex_counts) vertices += static_cast<std::size_t>(count);
    REQUIRE(vertices == polylines.positions.size());
    for (const auto& position : polylines.positions) REQUIRE(position.allFinite());
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

/// Feeds a reader every damaged version of a file: cut at each byte, and with each byte set to
/// extreme values. All must be read to finite strands or refused with an Error.
inline void damage(const std::string& extension, const std::string& bytes) {
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    refusal(extension, bytes.substr(0, size));
  }
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    for (const char value : {'\x00', '\x7f', '\x80', '\xff', '-', '9'}) {
      std::string damaged = bytes;
      damaged[i] = value;
      refusal(extension, damaged);
    }
  }
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace ringlet
