#include <fstream>
#include <iterator>

#include "core/registry.h"
#include "plugins/frames/frames_reader.h"
#include "plugins/frames/frames_writer.h"
#include "tests/catch.h"
#include "tests/temporary_folder.h"

using namespace ringlet;

namespace {

namespace fs = std::filesystem;

/// Two strands whose first positions are exact in single precision.
struct Written {
  explicit Written(FramePrecision precision, int every = 1)
      : model(Strands({2, 3}, rest, Material{})),
        state{0, positions_with_pads(model.groups, rest), VertexField(model.groups)},
        writer({every, precision}) {
    writer.begin(model, state, folder.path());
  }
  void step(int number) {
    state.time = 0.25 * number;
    state.positions.add(4, {0.1, 0, 0});
    writer.observe(model, state, number, {});
  }
  fs::path path() const { return folder.path() / "frames.bin"; }

  TemporaryFolder folder;
  std::vector<Eigen::Vector3d> rest{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 3, 0}, {0, 3, 5}};
  Model model;
  State state;
  FramesWriter writer;
};

std::string read_bytes(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void overwrite(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

}  // namespace

TEST_CASE("frames are read back, in double precision to the bit") {
  for (const FramePrecision precision : {FramePrecision::twice, FramePrecision::single}) {
    Written run(precision, 2);
    for (int n = 1; n <= 5; ++n) run.step(n);
    run.writer.end(run.model, run.state, 5);
    FramesReader reader(run.path());
    CHECK(reader.header().vertex_counts == std::vector<int>{2, 3});
    REQUIRE(reader.radii().size() == 5);
    CHECK(reader.radii()[4] == Approx(run.model.strands.radius(4)));
    REQUIRE(reader.count() == 4);
    const std::vector<int> steps{0, 2, 4, 5};
    for (int i = 0; i < 4; ++i) {
      const StoredFrame frame = reader.read(i);
      CHECK(frame.step == steps[i]);
      CHECK(frame.time == 0.25 * steps[i]);
      CHECK(frame.positions.col(3) == Eigen::Vector3d(0, 3, 0));
      CHECK((frame.positions.col(4) - Eigen::Vector3d(0.1 * steps[i], 3, 5)).norm() < 1e-6);
    }
    if (precision == FramePrecision::twice) {
      CHECK(reader.read(3).positions == run.state.positions.matrix());
    }
  }
}

TEST_CASE("frames are there while the run goes on, whole up to the last complete one") {
  Written run(FramePrecision::twice);
  FramesReader reader(run.path());
  CHECK(reader.count() == 1);
  run.step(1);
  CHECK(reader.count() == 2);
  CHECK(reader.read(1).step == 1);
  fs::resize_file(run.path(), fs::file_size(run.path()) - 1);
  CHECK(reader.count() == 1);
  CHECK_THROWS_WITH(reader.read(1), Catch::Contains("no frame 1 of 1"));
}

TEST_CASE("a damaged file of frames is refused with the reason") {
  Written run(FramePrecision::twice);
  run.step(1);
  const std::string whole = read_bytes(run.path());
  std::string damaged = whole;
  damaged[whole.size() - 20] = static_cast<char>(damaged[whole.size() - 20] + 1);
  overwrite(run.path(), damaged);
  FramesReader reader(run.path());
  CHECK(reader.read(0).step == 0);
  CHECK_THROWS_WITH(reader.read(1), Catch::Contains("frame 1 is damaged"));
  for (const auto& [bytes, reason] : std::vector<std::pair<std::string, std::string>>{
           {"", "begins with"},
           {"something else altogether", "begins with"},
           {whole.substr(0, 30), "longer than the file"},
           {whole.substr(0, 16) + std::string(8, '\x7f') + whole.substr(24),
            "longer than the file"},
           {whole.substr(0, 90), "ends before its first frame"},
           {std::string(whole).replace(40, 1, "#"), "its head"},
           {std::string("ringlet frames 2\2\0\0\0\0\0\0\0{}", 26), "vertex_counts"},
           {std::string("ringlet frames 2\2\0\0\0\0\0\0\0[[", 26), "expected an object"}}) {
    CAPTURE(reason);
    overwrite(run.path(), bytes);
    CHECK_THROWS_WITH(FramesReader(run.path()), Catch::Contains(reason));
  }
  CHECK_THROWS_WITH(FramesReader(run.folder.path() / "none"), Catch::Contains("cannot be read"));
}
