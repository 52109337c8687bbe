#include "core/readers/file_bytes.h"

#include <fstream>

#include "core/error.h"

namespace ringlet {

std::string read_bytes(const std::filesystem::path& file) {
  std::error_code failure;
  const auto size = std::filesystem::file_size(file, failure);
  std::ifstream stream(file, std::ios::binary);
  if (failure || !stream) throw Error("cannot open '" + file.string() + "'");
  std::string bytes(size, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(size));
  if (!stream) throw Error("cannot read '" + file.string() + "'");
  return bytes;
}

void FileBytes::require(std::uint64_t bytes, const std::string& what) const {
  if (bytes <= left()) return;
  fail("expected " + std::to_string(bytes) + " bytes of " + what + ", but only " +
       std::to_string(left()) + " are left in the file");
}

void FileBytes::skip(std::uint64_t bytes, const std::string& what) {
  require(bytes, what);
  position_ += bytes;
}

Eigen::Vector3d FileBytes::take_point() {
  require(3 * sizeof(float), "a vertex");
  Eigen::Vector3d point;
  for (double& coordinate : point) coordinate = take<float>("a coordinate");
  if (!point.allFinite()) {
    position_ -= 3 * sizeof(float);
    fail("expected a vertex with finite coordinates");
  }
  return point;
}

void FileBytes::fail(const std::string& problem) const {
  throw Error("'" + file_.string() + "', byte " + std::to_string(position_) + ": " + problem);
}

}  // namespace ringlet
