#include <fstream>

#include "core/registry.h"
#include "plugins/frames/frames_writer.h"
#include "plugins/run_frames.h"
#include "plugins/vtp/vtp_writer.h"
#include "tests/catch.h"
#include "tests/temporary_folder.h"

using namespace ringlet;
namespace fs = std::filesystem;

namespace {

/// Three states of two strands, as a writer keeps them.
struct WrittenByEach {
  explicit WrittenByEach(Observer& writer)
      : model(Strands({2, 3}, rest, Material{})),
        state{0, positions_with_pads(model.groups, rest), VertexField(model.groups)} {
    writer.begin(model, state, folder.path());
    for (int step = 1; step <= 2; ++step) {
      state.time = 0.25 * step;
      state.positions.add(4, {0.125, 0, 0});
      writer.observe(model, state, step, {});
    }
    writer.end(model, state, 2);
  }

  TemporaryFolder folder;
  std::vector<Eigen::Vector3d> rest{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 3, 0}, {0, 3, 5}};
  Model model;
  State state;
};

void check_frames(const WrittenByEach& run) {
  RunFrames frames(run.folder.path());
  CHECK(frames.vertex_counts() == std::vector<int>{2, 3});
  REQUIRE(frames.radii().size() == 5);
  CHECK(frames.radii()[4] == Approx(run.model.strands.radius(4)));
  CHECK(frames.steps() == std::vector<int>{0, 1, 2});
  for (int number = 0; number < 3; ++number) {
    const RunFrame frame = frames.read(number);
    CHECK(frame.step == number);
    CHECK(frame.time == 0.25 * number);
    CHECK(frame.positions.col(4) == Eigen::Vector3d(0.125 * number, 3, 5));
  }
  CHECK(frames.left_out().empty());
}

}  // namespace

TEST_CASE("frames of a run are read, whichever writer wrote them") {
  FramesWriter frames{FramesParameters{}};
  check_frames(WrittenByEach(frames));
  VtpWriter vtp{VtpParameters{}};
  check_frames(WrittenByEach(vtp));
}

TEST_CASE("what a run that was killed left of its last frame is left out, and told") {
  VtpWriter writer{VtpParameters{}};
  const WrittenByEach run(writer);
  fs::resize_file(run.folder.path() / "frames/frame_00002.vtp", 300);
  const RunFrames frames(run.folder.path());
  CHECK(frames.steps() == std::vector<int>{0, 1});
  REQUIRE(frames.left_out().size() == 1);
  CHECK_THAT(frames.left_out()[0], Catch::Contains("frame_00002.vtp"));
}

TEST_CASE("a folder without frames is refused with what was expected") {
  const TemporaryFolder folder;
  CHECK_THROWS_WITH(RunFrames(folder.path()),
                    Catch::Contains("has no frame") && Catch::Contains("\"write\""));
}
