#pragma once

#include <filesystem>
#include <fstream>

namespace ringlet {

/// Writes a file that appears whole or not at all: what is written goes to a temporary file beside
/// it, which commit() renames. Without commit() nothing remains.
class AtomicFile {
 public:
  /// Throws Error if the file cannot be created.
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  std::ostream& stream() { return stream_; }
  /// Throws Error if anything could not be written; an older file of this name is then as it was.
  void commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path temporary_;
  std::ofstream stream_;
};

}  // namespace ringlet
