// A run that goes on after a break ends as one without a break, to the bit.

#include <cmath>
#include <csignal>
#include <sstream>

#include "tests/apps/program.h"
#include "tests/catch.h"

using namespace ringlet;
namespace fs = std::filesystem;

namespace {

/// All that a step can depend on, and every writer.
Json lively_scene(double checkpoint_seconds) {
  Json scene = small_scene();
  scene["motions"]["shake"] = {
      {{"type", "sinusoid"}, {"frequency", 2}, {"translation", {0.02, 0, 0}}}};
  scene["strands"]["motion"] = "shake";
  scene["rest"] = "sag_free";
  scene["collision"]["friction"] = 0.3;
  scene["integrator"] = {{"type", "bdf2"}, {"sleep_speed", 1e-4}};
  scene["expect"] = {{{"step", 2}, {"quantity", "max_rest_distance"}, {"min", 0}}};
  scene["run"] = {{"steps", 60},
                  {"checkpoint_seconds", checkpoint_seconds},
                  {"write",
                   {{{"type", "vtp"}, {"every", 3}},
                    {{"type", "frames"}, {"every", 4}, {"precision", "double"}},
                    {{"type", "usda"}, {"every", 3}},
                    {{"type", "obj"}, {"every", 7}},
                    {{"type", "ply"}, {"every", 3}},
                    {{"type", "hair"}, {"every", 20}},
                    {{"type", "data"}, {"every", 7}}}}};
  return scene;
}

/// Of all that two runs wrote, what differs but for times.
std::vector<std::string> differences(const fs::path& a, const fs::path& b) {
  std::vector<std::string> found;
  for (const char* file : {"frames.bin", "run.pvd", "run.usda", "scene.resolved.json"}) {
    if (read_text(a / file) != read_text(b / file)) found.push_back(file);
  }
  if (read_files(a / "frames") != read_files(b / "frames")) found.push_back("frames");
  const auto metrics_a = read_metrics(a / "metrics.csv"),
             metrics_b = read_metrics(b / "metrics.csv");
  for (const auto& [name, column] : metrics_a) {
    if (name.ends_with("_ms")) continue;
    const auto& other = metrics_b.at(name);
    bool same = column.size() == other.size();
    for (std::size_t i = 0; same && i < column.size(); ++i) {
      same = column[i] == other[i] || (std::isnan(column[i]) && std::isnan(other[i]));
    }
    if (!same) found.push_back(name);
  }
  return found;
}

ProgramResult run_whole(const Workplace& place, const std::string& scene) {
  const ProgramResult result = place.run({"run", scene, "-o", "whole"});
  CAPTURE(result.errors);
  REQUIRE(result.exit_code == 0);
  return result;
}

int steps_of(const fs::path& folder) { return count_lines(read_text(folder / "metrics.csv")) - 1; }

}  // namespace

TEST_CASE("a run that is killed at any moment resumes and ends bit-identical") {
  // A checkpoint after every step, now and then, never.
  const double checkpoint_seconds = GENERATE(1e-9, 0.01, 0.0);
  const Workplace place;
  const std::string scene = place.write("s.json", lively_scene(checkpoint_seconds).dump());
  run_whole(place, scene);
  const fs::path whole = place.folder() / "whole", broken = place.folder() / "broken";
  place.run_and_signal({"run", scene, "-o", "broken"}, "broken", 1, SIGKILL);
  for (const int lines : {2, 9, 20, 33}) {
    if (!fs::exists(broken / "scene.resolved.json")) continue;
    place.run_and_signal({"run", "--resume", "broken"}, "broken", lines, SIGKILL);
    CHECK_FALSE(fs::exists(broken / "summary.json"));
  }
  CHECK(steps_of(broken) < 60);
  const ProgramResult result = place.run({"run", "--resume", "broken"});
  CAPTURE(checkpoint_seconds, result.errors);
  CHECK(result.exit_code == 0);
  CHECK(differences(whole, broken) == std::vector<std::string>());
  const Json summary = Json::parse(read_text(broken / "summary.json"));
  CHECK(summary["status"] == "finished");
  CHECK(summary["steps"] == 60);
  CHECK(summary["expect"][0]["met"] == true);
}

TEST_CASE("a run that was interrupted goes on where it was") {
  const Workplace place;
  const std::string scene = place.write("s.json", lively_scene(10).dump());
  run_whole(place, scene);
  const ProgramResult first =
      place.run_and_signal({"run", scene, "-o", "broken"}, "broken", 10, SIGINT);
  REQUIRE(first.exit_code == 130);
  const int done = steps_of(place.folder() / "broken");
  const ProgramResult second = place.run({"run", "--resume", "broken", "--quiet"});
  CAPTURE(second.errors);
  CHECK(second.exit_code == 0);
  CHECK(differences(place.folder() / "whole", place.folder() / "broken").empty());
  const ProgramResult third = place.run({"run", "--resume", "broken"});
  CHECK_THAT(third.errors, Catch::Contains("going on after step 60 of 60"));
  CHECK(done < 60);
}

TEST_CASE("a run that has ended goes on for more steps") {
  const Workplace place;
  const std::string scene = place.write("s.json", lively_scene(1e-9).dump());
  run_whole(place, scene);
  REQUIRE(place.run({"run", scene, "-o", "broken", "--steps", "31"}).exit_code == 0);
  const ProgramResult result = place.run({"run", "--resume", "broken", "--steps", "60"});
  CAPTURE(result.errors);
  CHECK(result.exit_code == 0);
  CHECK_THAT(result.errors, Catch::Contains("going on after step 31 of 60"));
  CHECK(differences(place.folder() / "whole", place.folder() / "broken").empty());
}

TEST_CASE("what cannot be resumed is refused with the reason, and nothing changes") {
  const Workplace place;
  Json scene = lively_scene(1e-9);
  scene["run"]["steps"] = 5;
  const std::string file = place.write("s.json", scene.dump());
  run_whole(place, file);
  const fs::path whole = place.folder() / "whole";
  const auto before = read_files(whole);
  const auto refusal = [&](const std::vector<std::string>& words) {
    const ProgramResult result = place.run(words);
    CHECK(result.exit_code == 2);
    return result.errors;
  };
  CHECK_THAT(refusal({"run"}), Catch::Contains("either SCENE.json or --resume DIR"));
  CHECK_THAT(refusal({"run", file, "--resume", "whole"}), Catch::Contains("either SCENE.json or"));
  CHECK_THAT(refusal({"run", "--resume", "absent"}), Catch::Contains("no folder of results"));
  CHECK_THAT(refusal({"run", "--resume", "whole", "--set", "/run/steps=9"}),
             Catch::Contains("'--set' cannot be given with --resume"));
  CHECK_THAT(refusal({"run", "--resume", "whole", "--steps", "3"}),
             Catch::Contains("at step 5 already"));
  CHECK(read_files(whole) == before);

  std::string checkpoint = before.at("checkpoint.bin");
  checkpoint[checkpoint.size() / 2] ^= 1;
  place.write("whole/checkpoint.bin", checkpoint);
  CHECK_THAT(refusal({"run", "--resume", "whole"}), Catch::Contains("checksum"));
  place.write("whole/checkpoint.bin", before.at("checkpoint.bin"));
  Json other = Json::parse(before.at("scene.resolved.json"));
  other["strands"][0]["count"] = 3;
  place.write("whole/scene.resolved.json", other.dump());
  CHECK_THAT(refusal({"run", "--resume", "whole"}),
             Catch::Contains("of 300 vertices; expected 45"));
  place.write("whole/scene.resolved.json", before.at("scene.resolved.json"));
  CHECK(read_files(whole) == before);
}

TEST_CASE("every step and the summary are lines of JSON for programs that ask") {
  const Workplace place;
  const std::string scene = place.write("s.json", small_scene().dump());
  const ProgramResult result = place.run({"run", scene, "-o", "out", "--json-lines", "--quiet"});
  CHECK(result.errors.empty());
  std::istringstream text(result.output);
  std::vector<Json> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(Json::parse(line));
  REQUIRE(lines.size() == 7);
  const auto metrics = read_metrics(place.folder() / "out/metrics.csv");
  for (std::size_t step = 0; step < 6; ++step) {
    CHECK(lines[step].size() == metrics.size());
    CHECK(lines[step]["kinetic_energy"] == metrics.at("kinetic_energy")[step]);
    CHECK(lines[step]["crossings"].is_null());
  }
  CHECK(lines[6]["folder"] == "out");
  CHECK(lines[6]["summary"] == Json::parse(read_text(place.folder() / "out/summary.json")));
}
