#include <csignal>

#include "tests/apps/program.h"
#include "tests/catch.h"

using namespace ringlet;

TEST_CASE("Ctrl-C ends the run after a whole step with everything so far readable") {
  const Workplace place;
  const std::string scene = place.write("s.json", small_scene().dump());
  const ProgramResult result =
      place.run_and_signal({"run", scene, "-o", "out", "--steps", "1000000", "--set",
                            R"(/run/write=[{"type": "vtp", "every": 7}])"},
                           "out", 10, SIGINT);
  CAPTURE(result.errors);
  CHECK(result.exit_code == 130);

  const auto out = place.folder() / "out";
  const Json summary = Json::parse(read_text(out / "summary.json"));
  CHECK(summary["status"] == "interrupted");
  const int steps = summary["steps"];
  CHECK(steps >= 9);
  const auto metrics = read_metrics(out / "metrics.csv");
  CHECK(metrics.at("step").size() == static_cast<std::size_t>(steps));
  CHECK(metrics.at("step").back() == steps);

  const std::string index = read_text(out / "run.pvd");
  CHECK(index.find("</VTKFile>") != std::string::npos);
  const auto frames = read_files(out / "frames");
  CHECK(frames.size() == static_cast<std::size_t>(1 + steps / 7 + (steps % 7 == 0 ? 0 : 1)));
  for (const auto& [name, bytes] : frames) {
    CHECK(name.ends_with(".vtp"));
    CHECK(index.find("frames/" + name) != std::string::npos);
    CHECK(bytes.ends_with("</VTKFile>\n"));
  }
}
