#include <cmath>
#include <fstream>
#include <regex>

#include "apps/report/report.h"
#include "collision/modules.h"
#include "core/modules.h"
#include "energies/modules.h"
#include "plugins/modules.h"
#include "plugins/vtp/vtp_reader.h"
#include "solvers/modules.h"
#include "tests/apps/program.h"
#include "tests/apps/report/unpack.h"
#include "tests/catch.h"

using namespace ringlet;
namespace fs = std::filesystem;

namespace {

constexpr std::int64_t plenty = 1000000000;

Json scene_with_colliders() {
  Json scene = small_scene();
  scene["motions"] = Json::parse(R"({"turn": [
    {"type": "keyframes", "times": [0, 0.2], "translations": [[0, 0, 0], [0.02, 0, 0]]}]})");
  scene["collision"]["colliders"] = Json::parse(R"([
    {"type": "sphere", "radius": 0.01, "centre": [0, -0.5, 0], "motion": "turn"},
    {"type": "plane", "point": [0, -1, 0], "normal": [0, 1, 0]}])");
  return scene;
}

/// A run of six steps with seven frames.
struct Run {
  explicit Run(const Json& scene = small_scene()) {
    place.write("s.json", scene.dump());
    const ProgramResult result = place.run({"run", "s.json", "-o", "out"});
    REQUIRE(result.exit_code == 0);
    register_core(registry);
    register_energies(registry);
    register_solvers(registry);
    register_collision(registry);
    register_plugins(registry);
  }
  fs::path folder() const { return place.folder() / "out"; }
  fs::path frame(int step) const {
    return folder() / ("frames/frame_0000" + std::to_string(step) + ".vtp");
  }
  ReportContent report(std::int64_t budget = plenty) const {
    const Report made = make_report(folder(), "<html><!--DATA--></html>", budget, registry);
    CHECK(made.html.starts_with("<html><script"));
    CHECK(made.html.ends_with("</script>\n</html>"));
    return read_report(made.html);
  }

  Workplace place;
  Registry registry;
};

void check_frame(const ReportContent& content, std::size_t number, const VtpFrame& written) {
  REQUIRE(content.frames.at(number).size() == written.points.size());
  double worst = 0;
  for (std::size_t i = 0; i < written.points.size(); ++i) {
    const double step = content.record["frames"]["step"][i % 3];
    const double error = std::abs(content.frames[number][i] - written.points[i]);
    worst = std::max(worst, error / step);
  }
  CHECK(worst <= 0.5001);
}

bool notes_contain(const ReportContent& content, const std::string& part) {
  return content.record["notes"].dump().find(part) != std::string::npos;
}

void cut(const fs::path& path, std::uintmax_t left) { fs::resize_file(path, left); }

}  // namespace

TEST_CASE("a report holds every frame, as exactly as it says") {
  const Run run;
  const ReportContent content = run.report();
  CHECK(content.record["frames"]["steps"] == Json({0, 1, 2, 3, 4, 5, 6}));
  REQUIRE(content.frames.size() == 7);
  for (int step = 0; step <= 6; ++step) {
    const VtpFrame written = read_vtp_frame(run.frame(step));
    check_frame(content, static_cast<std::size_t>(step), written);
    CHECK(content.record["frames"]["times"][step] == written.time);
  }
  CHECK(content.record["strands"]["count"] == 20);
  CHECK(content.record["frames"]["radius"] > 0.01);
  CHECK(unpack_text(content.record["strands"]["radii"]).size() == 4 * 300);
  CHECK(notes_contain(content, "rounded to 16 bits"));
}

TEST_CASE("a report of frames.bin is that of the same frames as .vtp") {
  Json scene = small_scene();
  const ReportContent vtp = Run(scene).report();
  scene["run"]["write"] = {"frames"};
  const ReportContent binary = Run(scene).report();
  CHECK(binary.frames == vtp.frames);
  CHECK(binary.contacts == vtp.contacts);
  CHECK(binary.record["strands"] == vtp.record["strands"]);
  CHECK(binary.record["frames"] == vtp.record["frames"]);
}

TEST_CASE("a report holds the metrics, the scene and what it was computed with") {
  const Run run;
  const Json record = run.report().record;
  CHECK(record["name"] == "s");
  CHECK(record["scene"] == Json::parse(read_text(run.folder() / "scene.resolved.json")));
  CHECK(record["summary"] == Json::parse(read_text(run.folder() / "summary.json")));
  const auto metrics = read_metrics(run.folder() / "metrics.csv");
  CHECK(record["metrics"]["names"].size() == metrics.size());
  for (std::size_t i = 0; i < metrics.size(); ++i) {
    const auto& column = metrics.at(record["metrics"]["names"][i]);
    for (std::size_t row = 0; row < column.size(); ++row) {
      const Json& shown = record["metrics"]["columns"][i][row];
      CHECK((std::isnan(column[row]) ? shown.is_null() : shown == column[row]));
    }
  }
}

TEST_CASE("colliders are shown where they are at each frame") {
  const Json record = Run(scene_with_colliders()).report().record;
  REQUIRE(record["colliders"].size() == 2);
  const Json& sphere = record["colliders"][0];
  CHECK(sphere["radius"] == 0.01);
  CHECK(sphere["poses"].size() == 7);
  CHECK(sphere["poses"][0] == Json({0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}));
  CHECK(sphere["poses"][3][0].get<double>() == Approx(0.01));
  CHECK(sphere["poses"][6][0].get<double>() == Approx(0.02));
}

TEST_CASE("contact forces are those of the collision stage") {
  Json scene = small_scene();
  // Two edges that cross far from each other, and a third one alone.
  scene["strands"] = Json::parse(R"({"type": "explicit", "pinned": 0, "strands": [
    [[0, 0, 0], [0.01, 0, 0]],
    [[0.005, 0.0625, -0.005], [0.005, 0.0625, 0.005]],
    [[1, 0, 0], [1.01, 0, 0]]]})");
  scene["run"] = Json::parse(R"({"steps": 0, "write": [{"type": "vtp", "encoding": "ascii"}]})");
  const Run run(scene);
  CHECK(run.report().record["contacts"]["largest"] == 0);

  const std::string text = read_text(run.frame(0));
  std::ofstream(run.frame(0)) << std::regex_replace(text, std::regex("0\\.0625"), "0.0004");
  const ReportContent near = run.report();
  // k (h - d) at the middle of both edges, half of it for each vertex.
  const double half = 0.5 * 2 * (1e-3 - 4e-4);
  CHECK(near.record["contacts"]["largest"].get<double>() == Approx(half).epsilon(0.01));
  REQUIRE(near.contacts.size() == 1);
  CHECK(near.contacts[0] == std::vector<std::uint8_t>{255, 255, 255, 255, 0, 0});
}

TEST_CASE("a report does without the colour of contacts if the scene cannot be made again") {
  const Run run;
  Json scene = Json::parse(read_text(run.folder() / "scene.resolved.json"));
  scene["energies"].push_back("of_an_absent_plugin");
  std::ofstream(run.folder() / "scene.resolved.json") << scene;
  const ReportContent content = run.report();
  CHECK(content.frames.size() == 7);
  CHECK(content.record["contacts"].is_null());
  CHECK(notes_contain(content, "no colour for contacts"));
}

TEST_CASE("a small budget leaves strands out, and the page says so") {
  const Run run;
  const ReportContent content = run.report(7 * 6 * 300 / 4);
  CHECK(content.record["strands"]["first"].size() == 6);
  REQUIRE(content.frames.size() == 7);
  CHECK(notes_contain(content, "5 of 20 strands, one of 4"));
  const VtpFrame written = read_vtp_frame(run.frame(6));
  // The second that is shown is the fifth of the run.
  CHECK(content.frames[6][3 * 15] == Approx(written.points[3 * 4 * 15]).margin(1e-5));
}

TEST_CASE("a run that was cut off is shown up to its last whole frame") {
  const Run run;
  fs::remove(run.folder() / "summary.json");
  fs::remove(run.folder() / "run.pvd");
  cut(run.frame(6), 3000);
  cut(run.frame(5), 0);
  cut(run.folder() / "metrics.csv", fs::file_size(run.folder() / "metrics.csv") - 5);
  const ReportContent content = run.report();
  CHECK(content.frames.size() == 5);
  CHECK(content.record["summary"].is_null());
  CHECK(content.record["name"] == "out");
  CHECK(content.record["metrics"]["columns"][0].size() == 5);
  CHECK(notes_contain(content, "frame_00006.vtp"));
  check_frame(content, 4, read_vtp_frame(run.frame(4)));
}

TEST_CASE("text of a scene cannot end the element that holds it") {
  Json scene = small_scene();
  scene["about"] = "</script><script>alert(1)</script><!-- & \"";
  CHECK(Run(scene).report().record["scene"]["about"] == scene["about"]);
}

TEST_CASE("a report of what is no run, or has no frames, is refused") {
  const Run run;
  const auto refusal = [&](const fs::path& folder) -> std::string {
    try {
      make_report(folder, "<!--DATA-->", plenty, run.registry);
    } catch (const Error& error) {
      return error.what();
    }
    return "not refused";
  };
  CHECK_THAT(refusal(run.place.folder()), Catch::Contains("is no folder of results"));
  CHECK_THAT(refusal(run.place.folder() / "absent"), Catch::Contains("is no folder of results"));
  fs::remove_all(run.folder() / "frames");
  CHECK_THAT(refusal(run.folder()),
             Catch::Contains("has no frame") && Catch::Contains("\"write\": [\"frames\"]"));
  const ProgramResult result = run.place.run({"report", "absent"});
  CHECK(result.exit_code == 2);
  CHECK_FALSE(fs::exists(run.place.folder() / "absent"));
}
