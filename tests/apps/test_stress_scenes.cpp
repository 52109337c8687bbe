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
  const std::string dt = GENERATE("0.005", "0.01", "0.02");
  const ProgramResult result =
      place.run({"run", std::string(RINGLET_SCENES) + "/stress/" + name + ".json", "-o", "out",
                 "--set", "/run/write=[]", "--set", "/integrator/dt=" + dt});
  CAPTURE(name, dt, result.errors);
  REQUIRE(result.exit_code == 0);
  const auto metrics = read_metrics(place.folder() / "out/metrics.csv");
  CHECK(sum(metrics.at("crossings")) == 0);
  CHECK(sum(metrics.at("collider_depth")) == 0);
  CHECK(sum(metrics.at("contacts")) > 0);
}

TEST_CASE("with the barrier nothing crosses in the first lean of a hairball") {
  const bool with_barrier = GENERATE(true, false);
  const Workplace place;
  const ProgramResult result = place.run(
      {"run", std::string(RINGLET_SCENES) + "/hairball_2000.json", "-o", "out", "--steps", "90",
       "--set", "/strands/count=200", "--set", "/strands/roots/radius=0.03", "--set",
       "/collision/colliders/0/radius=0.0325", "--set", "/run/write=[]", "--set",
       "/collision/audit=true", "--set",
       std::string("/collision/response=") + (with_barrier ? "\"barrier\"" : "\"penalty\"")});
  CAPTURE(with_barrier, result.errors);
  REQUIRE(result.exit_code == 0);
  const auto metrics = read_metrics(place.folder() / "out/metrics.csv");
  CHECK((sum(metrics.at("crossings")) == 0) == with_barrier);
  CHECK(sum(metrics.at("collider_depth")) == 0);
}
