#include <limits>

#include "apps/expectations.h"
#include "tests/apps/program.h"
#include "tests/catch.h"

using namespace ringlet;

TEST_CASE("an expectation is met within its bounds and never by what is not a number") {
  const Expectation both{5, "time", 1.0, 2.0}, above{5, "time", 1.0, {}}, below{5, "time", {}, 2.0};
  const auto met = [](const Expectation& expectation, double value) {
    return ExpectationResult{expectation, value}.met();
  };
  CHECK((met(both, 1) && met(both, 2) && met(above, 9) && met(below, -9)));
  CHECK_FALSE((met(both, 0.9) || met(both, 2.1) || met(above, 0.9) || met(below, 2.1)));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE((met(both, nan) || met(above, nan) || met(below, nan)));
}

TEST_CASE("a run that is not as its scene expects says so and exits with 1") {
  const Workplace place;
  Json scene = small_scene();
  scene["expect"] = Json::parse(R"([{"step": 2, "quantity": "time", "min": 0.01, "max": 1},
                                    {"step": 4, "quantity": "kinetic_energy", "max": -1},
                                    {"step": 99, "quantity": "time", "max": 1}])");
  const ProgramResult result = place.run({"run", place.write("s.json", scene.dump()), "-o", "out"});
  CHECK(result.exit_code == 1);
  CHECK(result.errors.find("not as expected: step 4: kinetic_energy = ") != std::string::npos);
  CHECK(result.errors.find("not checked: step 99") != std::string::npos);

  const Json expect = Json::parse(read_text(place.folder() / "out/summary.json"))["expect"];
  REQUIRE(expect.size() == 3);
  CHECK(expect[0]["met"] == true);
  CHECK(expect[0]["value"].get<double>() == Approx(2.0 / 30));
  CHECK(expect[1]["met"] == false);
  CHECK(expect[2]["met"].is_null());

  scene["expect"].erase(1);
  CHECK(place.run({"run", place.write("s.json", scene.dump()), "-o", "good"}).exit_code == 0);
}
