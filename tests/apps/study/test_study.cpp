// `ringlet study` as a user runs it.

#include <csignal>
#include <fstream>

#include "tests/apps/program.h"
#include "tests/catch.h"

using namespace ringlet;

namespace {

namespace fs = std::filesystem;

/// One curl that hangs down, at two time steps.
Json small_study() {
  Json scene = small_scene();
  scene["strands"]["count"] = 3;
  scene["collision"] = nullptr;
  scene["material"]["youngs_modulus"] = 2e4;
  scene["integrator"] = {{"type", "bdf1"}, {"dt", 0.02}};
  return {{"scene", scene},
          {"duration", 0.2},
          {"compare_every", 0.04},
          {"axes", {{{"name", "dt"}, {"pointer", "/integrator/dt"}, {"values", {0.04, 0.02}}}}},
          {"reference", {{"set", {{"/integrator/dt", 0.0025}}}}}};
}

Json results_in(const Workplace& place, const std::string& folder) {
  return Json::parse(read_text(place.folder() / folder / "results.json"));
}

const Json& variant(const Json& results, const std::string& name) {
  for (const Json& entry : results["variants"]) {
    if (entry["name"] == name) return entry;
  }
  FAIL("there is no variant " << name);
  return results;
}

/// When each outcome of a run was written.
std::map<std::string, fs::file_time_type> run_times(const fs::path& folder) {
  std::map<std::string, fs::file_time_type> times;
  for (const auto& entry : fs::recursive_directory_iterator(folder / "runs")) {
    if (entry.path().filename() == "1.json") times[entry.path()] = fs::last_write_time(entry);
  }
  return times;
}

}  // namespace

TEST_CASE("a study tells errors, times and the front, and a finer step has the smaller error") {
  const Workplace place;
  const std::string file = place.write("steps.json", small_study().dump());
  const ProgramResult result = place.run({"study", file, "-o", "out"});
  CAPTURE(result.errors);
  REQUIRE(result.exit_code == 0);
  CHECK(result.output.find("out\n") != std::string::npos);
  const Json results = results_in(place, "out");
  CHECK(results["default"] == "dt=0.02");
  REQUIRE(results["variants"].size() == 2);
  const Json &coarse = variant(results, "dt=0.04"), &fine = variant(results, "dt=0.02");
  CHECK(coarse["status"] == "finished");
  CHECK(coarse["verdict"] == "held");
  CHECK(coarse["steps"] == 5);
  CHECK(fine["steps"] == 10);
  CHECK(coarse["at"].size() == 5);
  CHECK(coarse["at"].back()["time"] == Approx(0.2));
  const double coarse_error = coarse["errors"]["mean_distance"],
               fine_error = fine["errors"]["mean_distance"];
  CHECK(fine_error > 0);
  CHECK(coarse_error > 1.1 * fine_error);
  const Json& front = results["fronts"]["mean_distance"];
  CHECK(front.back() == "dt=0.02");
  CHECK_FALSE(results["recommendations"]["mean_distance"].empty());
  const std::string csv = read_text(place.folder() / "out/results.csv");
  CHECK(count_lines(csv) == 3);
  CHECK(csv.starts_with("name,\"dt\",status,"));
  CHECK(fs::exists(place.folder() / "out/runs/dt=0.02/1/metrics.csv"));
}

TEST_CASE("a study that is run again runs only what is new, and nothing else is touched") {
  const Workplace place;
  Json study = small_study();
  place.write("steps.json", study.dump());
  REQUIRE(place.run({"study", "steps.json", "-o", "out"}).exit_code == 0);
  const auto first = run_times(place.folder() / "out");
  study["axes"][0]["values"] = {0.04, 0.02, 0.01};
  place.write("steps.json", study.dump());
  REQUIRE(place.run({"study", "steps.json", "-o", "out"}).exit_code == 0);
  auto second = run_times(place.folder() / "out");
  CHECK(second.size() == first.size() + 1);
  for (const auto& [path, time] : first) CHECK(second.at(path) == time);

  study["scene"]["material"]["density"] = 100;
  place.write("steps.json", study.dump());
  REQUIRE(place.run({"study", "steps.json", "-o", "out"}).exit_code == 0);
  for (const auto& [path, time] : run_times(place.folder() / "out")) {
    CHECK(time != second.at(path));
  }
  fs::create_directory(place.folder() / "mine");
  std::ofstream(place.folder() / "mine/notes.txt") << "keep";
  CHECK(place.run({"study", "steps.json", "-o", "mine"}).exit_code == 2);
  CHECK(read_files(place.folder() / "mine").size() == 1);
}

TEST_CASE("variants that are refused, fail, or are not as expected are told, and nothing is lost") {
  const Workplace place;
  Json study = small_study();
  const double huge = 1e300;
  study["variants"] = {
      {{"name", "refused"}, {"set", {{"/material/density", -1}}}},
      {{"name", "failed"},
       {"set", {{"/forces", {{{"type", "gravity"}, {"acceleration", {huge, huge, huge}}}}}}}},
      {{"name", "unexpected"},
       {"set", {{"/expect", {{{"step", 2}, {"quantity", "time"}, {"max", 0}}}}}}}};
  place.write("steps.json", study.dump());
  const ProgramResult result = place.run({"study", "steps.json", "-o", "out"});
  CHECK(result.exit_code == 1);
  const Json results = results_in(place, "out");
  CHECK(results["variants"].size() == 5);
  CHECK(variant(results, "refused")["status"] == "refused");
  CHECK(variant(results, "refused")["verdict"] == "refused with reason");
  CHECK(variant(results, "refused")["reason"].get<std::string>().find("/material/density") !=
        std::string::npos);
  CHECK(variant(results, "failed")["status"] == "failed");
  CHECK(variant(results, "failed")["verdict"] == "refused with reason");
  CHECK(variant(results, "failed")["reason"].get<std::string>().find("not finite") !=
        std::string::npos);
  CHECK(variant(results, "failed")["seconds"].is_null());
  CHECK(variant(results, "unexpected")["status"] == "unexpected");
  CHECK(variant(results, "unexpected")["verdict"] == "not held");
  CHECK(variant(results, "unexpected")["reason"].get<std::string>().find("time") !=
        std::string::npos);
  CHECK(variant(results, "dt=0.02")["status"] == "finished");
  for (const char* word : {"refused", "failed", "unexpected"}) {
    CHECK(result.errors.find(word) != std::string::npos);
  }
}

TEST_CASE("variants whose names look alike as names of files do not share a folder") {
  const Workplace place;
  Json study = small_study();
  study["variants"] = {{{"name", "a b"}, {"set", {{"/material/density", 60}}}},
                       {{"name", "ab"}, {"set", {{"/material/density", 70}}}},
                       {{"name", "../a/b"}, {"set", {{"/material/density", 80}}}}};
  place.write("steps.json", study.dump());
  REQUIRE(place.run({"study", "steps.json", "-o", "out"}).exit_code == 0);
  const Json results = results_in(place, "out");
  CHECK(variant(results, "a b")["run"] == "runs/ab/1");
  CHECK(variant(results, "ab")["run"] == "runs/ab_2/1");
  CHECK(variant(results, "../a/b")["run"] == "runs/.._a_b/1");
  CHECK(run_times(place.folder() / "out").size() == 6);
}

TEST_CASE("an interrupted study goes on where it was") {
  const Workplace place;
  Json study = small_study();
  study["variants"] = {{{"name", "long"}, {"set", {{"/integrator/dt", 0.00001}}}}};
  place.write("steps.json", study.dump());
  const ProgramResult result =
      place.run_and_signal({"study", "steps.json", "-o", "out"}, "out/runs/long/1", 3, SIGINT);
  CHECK(result.exit_code == 130);
  const Json results = results_in(place, "out");
  CHECK(variant(results, "dt=0.02")["status"] == "finished");
  CHECK(variant(results, "long")["status"] == "interrupted");
  const auto before = run_times(place.folder() / "out");
  study["variants"] = {{{"name", "long"}, {"set", {{"/integrator/dt", 0.01}}}}};
  place.write("steps.json", study.dump());
  REQUIRE(place.run({"study", "steps.json", "-o", "out"}).exit_code == 0);
  const auto after = run_times(place.folder() / "out");
  for (const auto& [path, time] : before) CHECK(after.at(path) == time);
  CHECK(variant(results_in(place, "out"), "long")["status"] == "finished");
}

TEST_CASE("several variants at once have the same errors, and the times are said to be false") {
  const Workplace place;
  place.write("steps.json", small_study().dump());
  REQUIRE(place.run({"study", "steps.json", "-o", "one"}).exit_code == 0);
  REQUIRE(place.run({"study", "steps.json", "-o", "two", "--jobs", "2"}).exit_code == 0);
  const Json one = results_in(place, "one"), two = results_in(place, "two");
  for (const char* name : {"dt=0.04", "dt=0.02"}) {
    CHECK(variant(one, name)["errors"] == variant(two, name)["errors"]);
  }
  CHECK(one["timing_note"] == "");
  CHECK(two["timing_note"].get<std::string>().find("2 variants ran at once") == 0);
}

TEST_CASE("all that is wrong with a study is told at once, and nothing is written") {
  const Workplace place;
  Json study = small_study();
  study["duraton"] = 1;
  study["axes"][0].erase("pointer");
  study["errors"] = {"mean_distanc"};
  place.write("bad.json", study.dump());
  ProgramResult result = place.run({"study", "bad.json", "-o", "out"});
  CHECK(result.exit_code == 2);
  for (const char* part : {"/duraton", "did you mean 'duration'", "/axes/0: expected 'pointer'"}) {
    CAPTURE(part, result.errors);
    CHECK(result.errors.find(part) != std::string::npos);
  }
  study = small_study();
  study["axes"][0]["values"] = {0.03, 0.02};
  study["errors"] = {"mean_distance"};
  place.write("bad.json", study.dump());
  result = place.run({"study", "bad.json", "-o", "out"});
  CHECK(result.exit_code == 2);
  CHECK(result.errors.find("/axes/0/values/0: the time step 0.03 s does not divide") !=
        std::string::npos);
  CHECK_FALSE(fs::exists(place.folder() / "out"));
}
