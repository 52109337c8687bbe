#pragma once

#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <string>

namespace ringlet {

/// A file of given bytes that is gone at the end of its scope. No two have the same name, also
/// when tests run side by side.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& extension, const std::string& bytes)
      : path_(std::filesystem::temp_directory_path() /
              ("ringlet_test_" + std::to_string(getpid()) + "_" + std::to_string(next_number()) +
               "." + extension)) {
    std::ofstream(path_, std::ios::binary) << bytes;
  }
  ~TemporaryFile() { std::filesystem::remove(path_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  static int next_number() {
    static std::atomic<int> count = 0;
    return ++count;
  }

  std::filesystem::path path_;
};

}  // namespace ringlet
