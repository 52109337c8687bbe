#include <unistd.h>

#include "core/atomic_file.h"
#include "core/error.h"
#include "tests/catch.h"

using namespace ringlet;
namespace fs = std::filesystem;

namespace {

std::string read_text(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("a file appears whole or not at all") {
  const fs::path folder =
      fs::temp_directory_path() / ("ringlet_atomic_" + std::to_string(getpid()));
  fs::create_directory(folder);
  const fs::path path = folder / "file.txt";
  {
    AtomicFile file(path);
    file.stream() << "first" << std::flush;
    CHECK_FALSE(fs::exists(path));
    file.commit();
  }
  CHECK(read_text(path) == "first");
  {
    AtomicFile abandoned(path);
    abandoned.stream() << "half";
  }
  CHECK(read_text(path) == "first");
  AtomicFile next(path);
  next.stream() << "second";
  next.commit();
  CHECK(read_text(path) == "second");
  CHECK(std::distance(fs::directory_iterator(folder), {}) == 1);

  CHECK_THROWS_AS(AtomicFile(folder / "missing" / "file.txt"), Error);
  fs::remove_all(folder);
}

TEST_CASE("a full disk is an error and leaves the older file") {
  if (!fs::exists("/dev/full")) return;
  const fs::path folder =
      fs::temp_directory_path() / ("ringlet_atomic_full_" + std::to_string(getpid()));
  fs::create_directory(folder);
  fs::create_symlink("/dev/full", folder / "file.txt.part");
  AtomicFile file(folder / "file.txt");
  file.stream() << "text";
  CHECK_THROWS_AS(file.commit(), Error);
  CHECK_FALSE(fs::exists(folder / "file.txt"));
  fs::remove_all(folder);
}
