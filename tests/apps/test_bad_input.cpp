#include "tests/apps/program.h"
#include "tests/catch.h"

using namespace ringlet;

namespace {

// Runs a scene that must be refused: exit code 2 and no folder of results, named or not.
std::string refusal_of(const Json& scene, const std::vector<std::string>& options = {}) {
  const Workplace place;
  std::vector<std::string> words{"run", place.write("s.json", scene.dump())};
  words.insert(words.end(), options.begin(), options.end());
  const ProgramResult by_default = place.run(words);
  CHECK(by_default.exit_code == 2);
  words.insert(words.end(), {"-o", "out"});
  CHECK(place.run(words).exit_code == 2);
  CHECK(std::distance(std::filesystem::directory_iterator(place.folder()), {}) == 3);
  return by_default.errors;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a scene with seven mistakes gets seven messages, exit code 2, and no folder") {
  Json scene = small_scene();
  scene["strnads"] = 1;
  scene["strands"]["curl_radius"] = -0.005;
  scene["material"]["density"] = "heavy";
  scene["energies"][1] = "bendign";
  scene["collision"]["colliders"] = Json::parse(R"([{"type": "mesh", "path": "none.obj"}])");
  scene["integrator"] = Json::parse(R"({"type": "bdf1", "newton_iteratons": 3})");
  scene["expect"] = Json::parse(R"([{"step": 3, "quantity": "kinetic_enery", "max": 1}])");
  const std::string errors = refusal_of(scene);
  CAPTURE(errors);
  CHECK(contains(errors, "7 problems"));
  CHECK(count_lines(errors) == 8);
  CHECK(contains(errors, "/strnads: unknown key; did you mean 'strands'?"));
  CHECK(contains(errors, "/strands/curl_radius: expected number > 0 in m, found -0.005"));
  CHECK(contains(errors, "/material/density: expected number > 0 in kg/m^3, found \"heavy\""));
  CHECK(contains(errors, "/energies/1/type: there is no energy 'bendign'; did you mean 'bending'"));
  CHECK(contains(errors, "/collision/colliders/0/path: there is no file"));
  CHECK(contains(errors,
                 "/integrator/newton_iteratons: unknown key; did you mean "
                 "'newton_iterations'?"));
  CHECK(contains(errors,
                 "/expect/0/quantity: there is no quantity 'kinetic_enery'; did you mean "
                 "'kinetic_energy'?"));
}

TEST_CASE("mistakes in how pictures look are told with all others") {
  Json scene = small_scene();
  scene["strnads"] = 1;
  scene["render"] = Json::parse(R"({"childern": 100, "light": {"angle": -1}})");
  const std::string errors = refusal_of(scene);
  CAPTURE(errors);
  CHECK(contains(errors, "3 problems"));
  CHECK(contains(errors, "/strnads: unknown key"));
  CHECK(contains(errors, "/render/childern: unknown key; did you mean 'children'?"));
  CHECK(contains(errors, "/render/light/angle: expected number in [0, 0.5] in rad, found -1"));
  scene = small_scene();
  scene["render"] = 3;
  CHECK(contains(refusal_of(scene), "/render: expected object"));
}

TEST_CASE("other bad input is refused, too") {
  Json plugins = small_scene();
  plugins["plugins"] = Json::parse(R"(["./mine.so"])");
  CHECK(contains(refusal_of(plugins), "/plugins"));
  CHECK(contains(refusal_of(small_scene(), {"--set", "/run/stps=3"}), "did you mean 'steps'"));
  CHECK(contains(refusal_of(small_scene(), {"--set", "/energies/9=twist"}), "--set"));
  CHECK(contains(refusal_of(small_scene(), {"--threads", "0"}), "--threads"));
  CHECK(contains(refusal_of(small_scene(), {"--step", "3"}), "did you mean '--steps'"));
  CHECK(contains(refusal_of(Json::array()), "expected an object"));
}

TEST_CASE("a file that is missing or no JSON, and a command that is none, are refused") {
  const Workplace place;
  const ProgramResult missing = place.run({"run", "none.json"});
  CHECK(missing.exit_code == 2);
  CHECK(contains(missing.errors, "cannot open 'none.json'"));
  const ProgramResult broken = place.run({"run", place.write("s.json", "{\"run\": {\n]}")});
  CHECK(broken.exit_code == 2);
  CHECK(contains(broken.errors, "line 2"));
  const ProgramResult command = place.run({"rnu", "s.json"});
  CHECK(command.exit_code == 2);
  CHECK(contains(command.errors, "did you mean 'run'"));
  CHECK(place.run({}).exit_code == 2);
}
