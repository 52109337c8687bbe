#include <algorithm>

#include "tests/apps/program.h"
#include "tests/catch.h"

using namespace ringlet;

namespace {

double sum(const std::vector<double>& column) {
  double total = 0;
  for (const double value : column) total += value;
  return total;
}

}  // namespace

TEST_CASE("with the barrier nothing crosses in the stress scenes, whatever else happens") {
  const Workplace place;
  const std::string name = GENERATE("bundles", "drop", "fold");
  const ProgramResult result =
      place.run({"run", std::string(RINGLET_SCENES) + "/stress/" + name + ".json", "-o", "out",
                 "--set", "/run/write=[]"});
  CAPTURE(name, result.errors);
  REQUIRE(result.exit_code == 0);
  const auto metrics = read_metrics(place.folder() / "out/metrics.csv");
  CHECK(sum(metrics.at("crossings")) == 0);
  CHECK(sum(metrics.at("collider_depth")) == 0);
  CHECK(sum(metrics.at("contacts")) > 0);
}
