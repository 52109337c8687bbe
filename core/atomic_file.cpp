#include "core/atomic_file.h"

#include "core/error.h"

namespace ringlet {

AtomicFile::AtomicFile(std::filesystem::path path)
    : path_(std::move(path)),
      temporary_(path_.string() + ".part"),
      stream_(temporary_, std::ios::binary | std::ios::trunc) {
  if (!stream_) throw Error("cannot write '" + path_.string() + "'");
}

AtomicFile::~AtomicFile() {
  if (temporary_.empty()) return;
  stream_.close();
  std::error_code ignored;
  std::filesystem::remove(temporary_, ignored);
}

void AtomicFile::commit() {
  stream_.close();
  std::error_code error;
  if (stream_) std::filesystem::rename(temporary_, path_, error);
  if (!stream_ || error) throw Error("cannot write '" + path_.string() + "': is the disk full?");
  temporary_.clear();
}

}  // namespace ringlet
