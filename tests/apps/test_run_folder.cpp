#include <cmath>

#include "tests/apps/program.h"
#include "tests/catch.h"

using namespace ringlet;

TEST_CASE("no results are ever written over") {
  const Workplace place;
  const std::string scene = place.write("s.json", small_scene().dump());
  const auto run = [&](const std::vector<std::string>& options) {
    std::vector<std::string> words{"run", scene, "--steps", "1"};
    words.insert(words.end(), options.begin(), options.end());
    return place.run(words).exit_code;
  };
  CHECK(run({}) == 0);
  CHECK(run({}) == 0);
  CHECK(std::filesystem::exists(place.folder() / "results/s/summary.json"));
  CHECK(std::filesystem::exists(place.folder() / "results/s_2/summary.json"));

  std::filesystem::create_directory(place.folder() / "empty");
  CHECK(run({"-o", "empty"}) == 0);
  CHECK(run({"-o", "empty"}) == 2);
  CHECK(run({"-o", "new/deep"}) == 0);
  CHECK(run({"-o", "s.json"}) == 2);
  CHECK(read_text(place.folder() / "s.json") == small_scene().dump());
}

TEST_CASE("metrics and summary tell what happened") {
  const Workplace place;
  const std::string scene = place.write("s.json", small_scene().dump());
  const ProgramResult result =
      place.run({"run", scene, "-o", "out", "--threads", "1", "--set",
                 R"(/energies=["stretch", "bending", "bending"])", "--set",
                 R"(/integrator={"type": "bdf1", "newton_iterations": 1})"});
  REQUIRE(result.exit_code == 0);
  CHECK(result.errors.find("hit its iteration cap in 6 of 6 steps") != std::string::npos);

  const std::string text = read_text(place.folder() / "out/metrics.csv");
  CHECK(text.substr(0, text.find('\n')) ==
        "step,time,newton_iterations,newton_converged,newton_update,linear_iterations,"
        "linear_converged,linear_residual,line_search_halvings,substeps,local_error,local_error_"
        "met,kinetic_energy,"
        "energy_stretch,"
        "energy_bending,energy_bending_2,contact_energy,energy_rise,contacts,strand_contacts,"
        "collider_contacts,"
        "penetration,"
        "crossings,collider_depth,"
        "mean_rest_distance,max_rest_distance,detect_ms,couple_ms,evaluate_ms,solve_ms,line_search_"
        "ms,"
        "step_ms");
  const auto metrics = read_metrics(place.folder() / "out/metrics.csv");
  CHECK(metrics.at("step") == std::vector<double>{1, 2, 3, 4, 5, 6});
  CHECK(metrics.at("time").back() == Approx(0.2));
  CHECK(std::isnan(metrics.at("crossings").back()));
  CHECK(text.find("nan") == std::string::npos);
  CHECK(metrics.at("energy_bending").back() > 0);
  CHECK(metrics.at("energy_bending").back() == metrics.at("energy_bending_2").back());
  CHECK(metrics.at("mean_rest_distance").back() > metrics.at("mean_rest_distance").front());
  CHECK(metrics.at("max_rest_distance").back() > metrics.at("mean_rest_distance").back());

  const Json summary = Json::parse(read_text(place.folder() / "out/summary.json"));
  CHECK(summary["status"] == "finished");
  CHECK(summary["steps"] == 6);
  CHECK(summary["strands"] == 20);
  CHECK(summary["vertices"] == 300);
  CHECK(summary["degrees_of_freedom"] == 3 * (300 - 80));
  CHECK(summary["threads"] == 1);
  CHECK(summary["steps_newton_not_converged"] == 6);
  CHECK(summary["peak_memory_bytes"] > 1000000);
  CHECK_FALSE(summary.contains("solver"));

  REQUIRE(place.run({"run", scene, "-o", "auto", "--set", "/solver=auto"}).exit_code == 0);
  const Json chosen = Json::parse(read_text(place.folder() / "auto/summary.json"));
  CHECK(chosen["solver"].get<std::string>().find("no contact coupled any") != std::string::npos);
}

TEST_CASE("log, summary and check tell what a rest state holds") {
  const Workplace place;
  Json scene = small_scene();
  scene["rest"] = "sag_free";
  const std::string held = place.write("held.json", scene.dump());
  const ProgramResult result = place.run({"run", held, "-o", "held"});
  CHECK(result.exit_code == 0);
  CHECK(result.errors.find("sag_free") == std::string::npos);
  const Json rest = Json::parse(read_text(place.folder() / "held/summary.json"))["rest"];
  CHECK(rest["strands"] == 20);
  CHECK(rest["not_held"] == 0);
  CHECK(rest["unstable"] == 0);
  CHECK(rest["elements_without_rest"] == 0);
  CHECK(rest["acceleration"] < 1e-5);
  CHECK_THAT(place.run({"check", held}).output, Catch::Contains("sag_free: 20 of 20 strands held"));

  scene["strands"]["pinned"] = 1;
  const std::string loose = place.write("loose.json", scene.dump());
  const ProgramResult check = place.run({"check", loose});
  CHECK_THAT(check.output, Catch::Contains("sag_free: 0 of 20 strands held"));
  CHECK_THAT(check.errors, Catch::Contains("20 of 20 strands are not held"));
}
