#include <algorithm>

#include "tests/apps/program.h"
#include "tests/catch.h"

using namespace ringlet;

TEST_CASE("every shipped scene passes the check") {
  const Workplace place;
  int count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(RINGLET_SCENES)) {
    if (entry.is_directory()) continue;
    const ProgramResult result = place.run({"check", entry.path()});
    CAPTURE(entry.path(), result.errors);
    CHECK(result.exit_code == 0);
    CHECK(result.output.find(": ok") != std::string::npos);
    ++count;
  }
  CHECK(count >= 7);
}

TEST_CASE("single curls come back from deformed starts, also with many Newton iterations") {
  const Workplace place;
  const std::string name = GENERATE("smash", "jitter", "straighten", "compression");
  const std::string iterations = GENERATE("3", "50");
  const ProgramResult result =
      place.run({"run", std::string(RINGLET_SCENES) + "/" + name + ".json", "-o", "out", "--set",
                 "/run/write=[]", "--set", "/integrator/newton_iterations=" + iterations});
  CAPTURE(name, iterations, result.errors);
  CHECK(result.exit_code == 0);
  CHECK(result.errors.find("not checked") == std::string::npos);
  const Json summary = Json::parse(read_text(place.folder() / "out/summary.json"));
  CHECK_FALSE(summary["expect"].empty());
}

TEST_CASE("the first curl falls and stays whole") {
  const Workplace place;
  const ProgramResult result =
      place.run({"run", std::string(RINGLET_SCENES) + "/first_curl.json", "-o", "out"});
  CAPTURE(result.errors);
  REQUIRE(result.exit_code == 0);
  const auto metrics = read_metrics(place.folder() / "out/metrics.csv");
  const auto& distance = metrics.at("mean_rest_distance");
  CHECK(*std::max_element(distance.begin(), distance.end()) > 0.05);
  CHECK(*std::max_element(distance.begin(), distance.end()) < 1);
}
