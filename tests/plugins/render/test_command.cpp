#include <cstdlib>

#include "tests/apps/program.h"
#include "tests/catch.h"

using namespace ringlet;
namespace fs = std::filesystem;

namespace {

const std::string tiny =
    R"({"width": 80, "height": 60, "samples": 4, "children": 5, "child_radius": 1e-3})";

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// A run of six steps with seven frames.
struct Run {
  Run() {
    Json scene = small_scene();
    scene["render"] = Json::parse(tiny);
    place.write("s.json", scene.dump());
    REQUIRE(place.run({"run", "s.json", "-o", "out"}).exit_code == 0);
  }
  ProgramResult render(std::vector<std::string> options) const {
    options.insert(options.begin(), {"render", "out"});
    return place.run(options);
  }
  bool has(const std::string& name) const { return fs::exists(place.folder() / name); }

  Workplace place;
};

/// A program of this name stands for ffmpeg: it writes the list of files that it is given.
struct FakeFfmpeg {
  explicit FakeFfmpeg(const Workplace& place) : before(std::getenv("PATH")) {
    fs::create_directory(place.folder() / "bin");
    place.write("bin/ffmpeg", "#!/bin/sh\nfor last; do :; done\ncat > \"$last\"\n");
    fs::permissions(place.folder() / "bin/ffmpeg", fs::perms::owner_all);
    setenv("PATH", ((place.folder() / "bin").string() + ":" + before).c_str(), 1);
  }
  ~FakeFfmpeg() { setenv("PATH", before.c_str(), 1); }
  std::string before;
};

}  // namespace

TEST_CASE("render draws the last frame, one, or a range") {
  const Run run;
  const ProgramResult last = run.render({});
  CHECK(last.exit_code == 0);
  CHECK(last.output == "out/render.png\n");
  CHECK(run.has("out/render.png"));
  CHECK(run.render({"--frame", "0", "-o", "first.png"}).exit_code == 0);
  CHECK(run.has("first.png"));
  const bool differs = read_text(run.place.folder() / "first.png") !=
                       read_text(run.place.folder() / "out/render.png");
  CHECK(differs);
  const ProgramResult range = run.render({"--frames", "1:5:2", "-o", "many.png"});
  CHECK(range.output == "many_00001.png\nmany_00003.png\nmany_00005.png\n");
  CHECK(run.has("many_00003.png"));
}

TEST_CASE("how a picture looks is read from the scene, and changed by --set") {
  const Run run;
  const Json resolved = Json::parse(read_text(run.place.folder() / "out/scene.resolved.json"));
  CHECK(resolved["render"]["children"] == 5);
  CHECK(resolved["render"]["light"]["key"].is_number());
  const auto picture_with = [&](const std::string& change) {
    REQUIRE(run.render({"--set", change}).exit_code == 0);
    return read_text(run.place.folder() / "out/render.png");
  };
  const std::string plain = picture_with("/render/children=5");
  const bool more = picture_with("/render/children=6") != plain;
  const bool from_the_side = picture_with("/render/camera/direction=[1, 0, 0]") != plain;
  const bool same = picture_with("/render/children=5") == plain;
  CHECK(more);
  CHECK(from_the_side);
  CHECK(same);
}

TEST_CASE("bad input of render is refused, and nothing written") {
  const Run run;
  const auto refusal_of = [&](const std::vector<std::string>& options) {
    const ProgramResult result = run.render(options);
    CHECK(result.exit_code == 2);
    return result.errors;
  };
  CHECK(contains(refusal_of({"--frame", "7"}), "there are 7, of steps 0 to 6"));
  CHECK(contains(refusal_of({"--frames", "9"}), "expected A:B"));
  CHECK(contains(refusal_of({"--set", "/render/childern=3"}),
                 "/render/childern: unknown key; did you mean 'children'?"));
  CHECK(contains(refusal_of({"--set", "/render/camera/target=[0, 0, 0]"}), "'position'"));
  CHECK(contains(refusal_of({"--set", "/strands/count=3"}), "begins with /render/"));
  CHECK(contains(refusal_of({"-o", "none/x.png"}), "cannot write 'none/x.png'"));
  CHECK_FALSE(run.has("out/render.png"));
  CHECK(contains(run.place.run({"render", "none"}).errors, "'none'"));
  fs::create_directory(run.place.folder() / "empty");
  CHECK(contains(run.place.run({"render", "empty"}).errors, "'empty' has no frame"));
}

TEST_CASE("a video is made of the frames, as long as they last") {
  const Run run;
  const FakeFfmpeg ffmpeg(run.place);
  const ProgramResult result = run.render({"--frames", "0:6", "--video", "curls.mp4"});
  CHECK(result.exit_code == 0);
  const std::string list = read_text(run.place.folder() / "curls.mp4");
  CHECK(contains(list, "render_00006.png'\nduration 0.0333"));
  CHECK_FALSE(run.has("curls.part.mp4"));
}

TEST_CASE("ffmpeg itself makes the video, where there is one") {
  if (std::system("ffmpeg -version > /dev/null 2>&1") != 0) {
    WARN("there is no ffmpeg");
    return;
  }
  const Run run;
  const ProgramResult result = run.render({"--frames", "0:6", "--video", "curls.mp4"});
  CAPTURE(result.errors);
  CHECK(result.exit_code == 0);
  CHECK(read_text(run.place.folder() / "curls.mp4").substr(4, 4) == "ftyp");
}

TEST_CASE("without ffmpeg there is no video, and nothing is drawn") {
  const Run run;
  const FakeFfmpeg path(run.place);
  fs::remove(run.place.folder() / "bin/ffmpeg");
  setenv("PATH", (run.place.folder() / "bin").c_str(), 1);
  const ProgramResult result = run.render({"--video", "curls.mp4"});
  CHECK(result.exit_code == 2);
  CHECK(contains(result.errors, "install ffmpeg"));
  CHECK_FALSE(run.has("out/render.png"));
}
