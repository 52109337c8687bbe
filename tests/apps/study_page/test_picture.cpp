#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "apps/study/picture.h"
#include "apps/study/picture/child_program.h"
#include "core/error.h"
#include "tests/apps/study_page/sample_results.h"
#include "tests/catch.h"

using namespace ringlet;
namespace fs = std::filesystem;

namespace {

/// An empty folder that is removed at the end.
struct Folder {
  Folder() {
    std::string pattern = (fs::temp_directory_path() / "ringlet_picture_XXXXXX").string();
    REQUIRE(mkdtemp(pattern.data()) != nullptr);
    path = pattern;
  }
  ~Folder() { fs::remove_all(path); }
  fs::path path;
};

/// Programs are looked for in this folder alone.
struct SearchPath {
  explicit SearchPath(const fs::path& folder) : before(std::getenv("PATH")) {
    setenv("PATH", folder.c_str(), 1);
  }
  ~SearchPath() { setenv("PATH", before.c_str(), 1); }
  std::string before;
};

std::string read(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// A number of the head of a PNG file.
unsigned big_endian(const std::string& bytes, std::size_t at) {
  unsigned number = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    number = 256 * number + static_cast<unsigned char>(bytes.at(at + i));
  }
  return number;
}

bool has_gnuplot() {
  const bool there = run_program({"gnuplot", "--version"}, "").has_value();
  if (!there) WARN("gnuplot not found: the picture of a study is not drawn");
  return there;
}

}  // namespace

TEST_CASE("Gnuplot draws the picture of a study, whatever its names are") {
  if (!has_gnuplot()) return;
  const Folder folder;
  const std::string harmed = (folder.path / "harmed").string();
  Json results = sample_results();
  results["variants"][0]["name"] = results["fronts"]["mean_distance"][0] =
      "it's `touch " + harmed + "` '; system('touch " + harmed + "') # {/Symbol a} ^_ \\";
  draw_study(results, folder.path / "study.png");
  const std::string png = read(folder.path / "study.png");
  CHECK(png.starts_with("\x89PNG\r\n"));
  CHECK(png.size() > 20000);
  CHECK(big_endian(png, 16) == 1400);
  CHECK(big_endian(png, 20) == 900);
  CHECK(std::distance(fs::directory_iterator(folder.path), {}) == 1);
}

TEST_CASE("The picture of a study in which nothing ran is drawn nevertheless") {
  if (!has_gnuplot()) return;
  const Folder folder;
  Json results = sample_results();
  results["variants"] = Json::array();
  draw_study(results, folder.path / "study.png");
  CHECK(read(folder.path / "study.png").starts_with("\x89PNG\r\n"));
}

TEST_CASE("Without gnuplot the picture of a study says what to install and writes nothing") {
  const Folder folder;
  const SearchPath nowhere(folder.path);
  CHECK_THROWS_WITH(draw_study(sample_results(), folder.path / "study.png"),
                    contains("Debian: gnuplot-nox"));
  CHECK(fs::is_empty(folder.path));
}

TEST_CASE("A gnuplot that fails leaves the picture of before and is told with what it said") {
  const Folder folder;
  std::ofstream(folder.path / "study.png") << "before";
  std::ofstream(folder.path / "gnuplot") << "#!/bin/sh\necho 'no cairo here' >&2\nexit 1\n";
  fs::permissions(folder.path / "gnuplot", fs::perms::owner_all);
  const SearchPath fake(folder.path);
  CHECK_THROWS_WITH(draw_study(sample_results(), folder.path / "study.png"),
                    contains("no cairo here"));
  CHECK(read(folder.path / "study.png") == "before");
}
