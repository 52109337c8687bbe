#include "tests/apps/program.h"
#include "tests/catch.h"

using namespace ringlet;

namespace {

std::map<std::string, std::string> frames_of(const Workplace& place, const std::string& scene,
                                             const std::string& folder,
                                             const std::vector<std::string>& options) {
  std::vector<std::string> words{"run", scene, "-o", folder};
  words.insert(words.end(), options.begin(), options.end());
  const ProgramResult result = place.run(words);
  CAPTURE(result.errors);
  REQUIRE(result.exit_code == 0);
  return read_files(place.folder() / folder / "frames");
}

}  // namespace

TEST_CASE("one thread and two write the same bytes, and so does the resolved scene") {
  const Workplace place;
  const std::string scene = place.write("s.json", small_scene().dump());
  const auto one = frames_of(place, scene, "one", {"--threads", "1"});
  CHECK(one.size() == 7);
  CHECK(one.at("frame_00000.vtp") != one.at("frame_00006.vtp"));
  CHECK(frames_of(place, scene, "two", {"--threads", "2"}) == one);
  CHECK(frames_of(place, "one/scene.resolved.json", "again", {}) == one);
  CHECK(read_text(place.folder() / "one/scene.resolved.json") ==
        read_text(place.folder() / "again/scene.resolved.json"));
}

TEST_CASE("the option --set and --steps change the run, and the resolved scene says so") {
  const Workplace place;
  const std::string scene = place.write("s.json", small_scene().dump());
  const auto plain = frames_of(place, scene, "plain", {"--steps", "2"});
  CHECK(plain.size() == 3);
  const auto light = frames_of(
      place, scene, "light",
      {"--steps", "2", "--set", R"(/forces/0={"type": "gravity", "acceleration": [0, 1, 0]})"});
  CHECK(light.at("frame_00000.vtp") == plain.at("frame_00000.vtp"));
  CHECK(light.at("frame_00002.vtp") != plain.at("frame_00002.vtp"));
  const Json resolved = Json::parse(read_text(place.folder() / "light/scene.resolved.json"));
  CHECK(resolved["forces"][0]["acceleration"] == Json::array({0.0, 1.0, 0.0}));
  CHECK(resolved["run"]["steps"] == 2);
}
