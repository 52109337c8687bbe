#include "plugins/run_frames.h"
#include "plugins/vtp/pvd.h"
#include "tests/plugins/written_run.h"

using namespace ringlet;
namespace fs = std::filesystem;

TEST_CASE("the frames of an index are those of its run, by the steps in their names") {
  WrittenRun run(Json{{"type", "vtp"}, {"every", 2}});
  run.steps(1, 4);
  RunFrames frames(run.folder.path() / "run.pvd");
  CHECK(frames.steps() == std::vector<int>{0, 2, 4});
  CHECK(frames.read(2).time == Approx(WrittenRun::time(4)));
  CHECK(frames.read(2).positions.col(4).cast<float>() == WrittenRun::position(4, 4).cast<float>());
}

TEST_CASE("frames of an index whose names have no steps are counted") {
  WrittenRun run("vtp");
  run.steps(1, 1);
  const fs::path folder = run.folder.path();
  fs::rename(folder / "frames/frame_00001.vtp", folder / "tip.vtp");
  std::ofstream index(folder / "by_hand.pvd");
  write_pvd({{0, "frames/frame_00000.vtp"}, {7, "tip.vtp"}}, index);
  index.close();
  CHECK(RunFrames(folder / "by_hand.pvd").steps() == std::vector<int>{0, 1});
}

TEST_CASE("an index that is not whole is refused with the reason") {
  const std::string head = "<VTKFile type=\"Collection\">", tail = "</VTKFile>";
  const std::vector<std::pair<std::string, std::string>> table{
      {"", "is no whole .pvd"},
      {head, "is no whole .pvd"},
      {head + tail, "has no frame"},
      {head + "<DataSet file=\"a.vtp\"/>" + tail, "expected the attribute timestep"},
      {head + "<DataSet timestep=\"0\"/>" + tail, "expected the attribute file"},
      {head + "<DataSet timestep=\"0\" file=\"a.vtp" + tail, "expected the attribute file"},
      {head + "<DataSet timestep=\"x\" file=\"a.vtp\"/>" + tail, "expected a timestep, found 'x'"},
      {head + "<DataSet timestep=\"0\" file=\"none.vtp\"/>" + tail, "none.vtp"}};
  for (const auto& [bytes, reason] : table) {
    CAPTURE(bytes);
    const TemporaryFile file("pvd", bytes);
    CHECK_THROWS_WITH(RunFrames(file.path()), Catch::Contains(reason));
  }
}
