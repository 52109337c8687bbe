#pragma once

#include <Eigen/Core>
#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>

namespace ringlet {

/// The whole content of a file. Throws Error if it cannot be read.
std::string read_bytes(const std::filesystem::path& file);

/// Takes numbers out of a little-endian binary file, one after the other. Every error names the
/// file and the byte.
class FileBytes {
 public:
  explicit FileBytes(const std::filesystem::path& file) : file_(file), bytes_(read_bytes(file)) {}

  std::uint64_t left() const { return bytes_.size() - position_; }
  /// Throws Error unless at least so many bytes are left for what is to be read.
  void require(std::uint64_t bytes, const std::string& what) const;
  void skip(std::uint64_t bytes, const std::string& what);

  template <class T>
  T take(const std::string& what) {
    static_assert(std::endian::native == std::endian::little);
    require(sizeof(T), what);
    T value;
    std::memcpy(&value, bytes_.data() + position_, sizeof(T));
    position_ += sizeof(T);
    return value;
  }
  /// Three 32-bit floats, which must be finite.
  Eigen::Vector3d take_point();

  /// Throws Error with file and byte.
  [[noreturn]] void fail(const std::string& problem) const;

 private:
  std::filesystem::path file_;
  std::string bytes_;
  std::size_t position_ = 0;
};

}  // namespace ringlet
