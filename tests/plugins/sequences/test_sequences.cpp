#include <set>

#include "tests/plugins/written_run.h"

using namespace ringlet;
namespace fs = std::filesystem;

namespace {

struct Sequence {
  Json writer;
  std::string extension;
  bool has_radii;
};

const std::vector<Sequence>& sequences() {
  static const std::vector<Sequence> all{
      {{{"type", "obj"}, {"every", 2}}, "obj", false},
      {{{"type", "obj"}, {"every", 2}, {"lines", "edges"}}, "obj", false},
      {{{"type", "ply"}, {"every", 2}}, "ply", true},
      {{{"type", "ply"}, {"every", 2}, {"encoding", "ascii"}}, "ply", true},
      {{{"type", "hair"}, {"every", 2}}, "hair", true},
      {{{"type", "data"}, {"every", 2}}, "data", false},
      {{{"type", "vtp"}, {"every", 2}}, "vtp", true},
      {{{"type", "vtp"}, {"every", 2}, {"encoding", "ascii"}}, "vtp", true}};
  return all;
}

std::set<std::string> files_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

}  // namespace

TEST_CASE("a file a state is read back as it was written") {
  for (const auto& [writer, extension, has_radii] : sequences()) {
    CAPTURE(writer.dump());
    WrittenRun run(writer);
    run.steps(1, 5);
    run.end(5);
    const auto name = [end = "." + extension](int step) {
      return "frame_0000" + std::to_string(step) + end;
    };
    CHECK(files_in(run.folder.path() / "frames") ==
          std::set<std::string>{name(0), name(2), name(4), name(5)});
    for (const int step : {0, 2, 4, 5}) {
      const Polylines read = read_strands(run.folder.path() / "frames" / name(step));
      run.check(read, step);
      CHECK(read.radii.empty() != has_radii);
    }
  }
}

TEST_CASE("the last state is not written twice, and equal states give equal bytes") {
  for (const auto& [writer, extension, has_radii] : sequences()) {
    CAPTURE(writer.dump());
    WrittenRun run(writer), again(writer);
    const std::string last = "frames/frame_00002." + extension;
    run.steps(1, 2);
    again.steps(1, 2);
    CHECK(bytes_in(run.folder.path() / last) == bytes_in(again.folder.path() / last));
    fs::remove(run.folder.path() / last);
    run.end(2);
    CHECK_FALSE(fs::exists(run.folder.path() / last));
  }
}

TEST_CASE("a sequence that goes on after a break ends as without one") {
  for (const auto& [writer, extension, has_radii] : sequences()) {
    for (const int step : {2, 3}) {
      CAPTURE(writer.dump(), step);
      WrittenRun whole(writer), broken(writer);
      whole.steps(1, 5);
      whole.end(5);
      broken.steps(1, 3);
      broken.end(3);
      broken.resume(writer, step);
      broken.steps(step + 1, 5);
      broken.end(5);
      const auto names = files_in(whole.folder.path() / "frames");
      CHECK(files_in(broken.folder.path() / "frames") == names);
      for (const std::string& name : names) {
        const fs::path file = fs::path("frames") / name;
        CHECK(bytes_in(broken.folder.path() / file) == bytes_in(whole.folder.path() / file));
      }
    }
  }
}

TEST_CASE("damaged files of every format are read or refused, never crashed on") {
  for (const auto& [writer, extension, has_radii] : sequences()) {
    CAPTURE(writer.dump());
    const WrittenRun run(writer);
    damage_everywhere(extension, bytes_in(run.folder.path() / ("frames/frame_00000." + extension)));
  }
}

TEST_CASE("what a .hair file cannot hold is refused with the reason, and leaves no file") {
  std::vector<Eigen::Vector3d> line;
  for (int v = 0; v < 65537; ++v) line.emplace_back(1e-3 * v, 0, 0);
  const auto write = [&](int vertices) {
    const TemporaryFolder folder;
    const Model model(Strands({vertices}, {line.begin(), line.begin() + vertices}, Material{}));
    const State state{0, positions_with_pads(model.groups, line), VertexField(model.groups)};
    const auto writer = make_of_plugins<Observer>("hair");
    const fs::path file = folder.path() / "frames/frame_00000.hair";
    try {
      writer->begin(model, state, folder.path());
      return std::to_string(read_strands(file).vertex_counts.at(0));
    } catch (const Error& error) {
      CHECK(files_in(folder.path() / "frames").empty());
      return std::string(error.what());
    }
  };
  CHECK_THAT(write(65537),
             Catch::Contains("strand 0 has 65536 segments") && Catch::Contains("at most 65535"));
  line.pop_back();
  CHECK(write(65536) == "65536");
}

TEST_CASE("where a file cannot be written, its name is told") {
  WrittenRun run("obj");
  fs::remove_all(run.folder.path() / "frames");
  CHECK_THROWS_WITH(run.steps(1, 1), Catch::Contains("frame_00001.obj"));
}
