#include <regex>

#include "tests/apps/program.h"
#include "tests/catch.h"

using namespace ringlet;

namespace {

const char* const cases = R"({"cases": [
  {"energy": "stretch", "positions": [[0, 0, 0], [3, 0, 0]], "stiffness": 8, "rest": 2, "note": 1},
  {"energy": "bending", "positions": [[0, 1, 0], [0, 0, 0], [1, 0, 0]], "stiffness": 2, "rest": 1}]})";

}  // namespace

TEST_CASE("verify prints a table and says whether all claims hold") {
  const Workplace place;
  const ProgramResult result = place.run({"verify", "stretch", "--trials", "1", "--seed", "7"});
  CHECK(result.exit_code == 0);
  CHECK_THAT(result.output, Catch::Contains("the gradient is the derivative of the value"));
  CHECK_THAT(result.output, Catch::Contains("seed 7, 1 trials of each state; all claims hold"));
  CHECK(place.run({"verify", "twist", "--trials", "1", "--set", "/fade=0.01"}).exit_code == 0);

  // Where twist fades its Hessian is not the derivative of its gradient.
  const ProgramResult faded = place.run({"verify", "twist", "--trials", "1", "--set", "/fade=1"});
  CHECK(faded.exit_code == 1);
  CHECK_THAT(faded.output, Catch::Contains("FAILED: nearly straight"));
  CHECK_THAT(faded.output, Catch::Contains("claims do not hold"));

  const ProgramResult unknown = place.run({"verify", "twsit"});
  CHECK(unknown.exit_code == 2);
  CHECK_THAT(unknown.errors, Catch::Contains("did you mean 'twist'"));
  const ProgramResult bad = place.run({"verify", "twist", "--set", "/fade=2"});
  CHECK(bad.exit_code == 2);
  CHECK_THAT(bad.errors, Catch::Contains("/fade: expected number in"));
  CHECK(place.run({"verify", "--set", "/fade=1"}).exit_code == 2);
}

TEST_CASE("verify finds each of the deliberate mistakes of a plugin") {
  const Workplace place;
  const auto verify = [&](const std::string& mistake) {
    return place.run({"verify", "wrong_bending", "--plugin", RINGLET_WRONG_BENDING, "--trials", "2",
                      "--set", "/mistake=" + mistake});
  };
  CHECK(verify("none").exit_code == 0);
  const std::map<std::string, std::vector<std::string>> claims_of{
      {"sign", {"the gradient is the derivative of the value"}},
      {"factor", {"the Hessian is the derivative of the gradient"}},
      {"not_invariant", {"translations change nothing", "rotations turn gradient and Hessian"}},
      {"nan_when_straight", {"finite in degenerate states"}},
      {"rest", {"at rest there is no force"}},
      {"lanes", {"lanes compute what plain doubles do"}},
      {"indefinite", {"tight: positive semi-definite"}}};
  for (const auto& [mistake, claims] : claims_of) {
    INFO(mistake);
    const ProgramResult result = verify(mistake);
    CHECK(result.exit_code == 1);
    for (const std::string& claim : claims) {
      CHECK(std::regex_search(result.output, std::regex(claim + " .* FAILED: ")));
    }
  }
}

TEST_CASE("eval gives value, gradient and Hessian of each case") {
  const Workplace place;
  const std::string path = place.write("cases.json", cases);
  const ProgramResult plain = place.run({"eval", path});
  REQUIRE(plain.exit_code == 0);
  const Json results = Json::parse(plain.output)["cases"];
  REQUIRE(results.size() == 2);
  CHECK(results[0]["value"] == 1);
  CHECK(results[0]["gradient"] == Json::array({-2, 0, 0, 2, 0, 0}));
  CHECK(results[0]["hessian"][3][3] == 2);
  CHECK_FALSE(results[0].contains("filtered"));
  const double angle = std::acos(0) - 1;
  CHECK(double(results[1]["value"]) == Approx(angle * angle));

  const ProgramResult filtered = place.run({"eval", path, "--filter", "gauss_newton"});
  REQUIRE(filtered.exit_code == 0);
  const Json matrix = Json::parse(filtered.output)["cases"][0]["filtered"];
  CHECK(matrix[0][0] == 2);
  CHECK(matrix[1][1] == 0);
}

TEST_CASE("eval tells everything that is wrong with its cases") {
  const Workplace place;
  const ProgramResult result = place.run({"eval", place.write("bad.json", R"({"cases": [
      {"energy": "strech", "positions": [[0, 0, 0], [1, 0, 0]], "stiffness": 1, "rest": 1},
      {"energy": "bending", "positions": [[0, 0, 0], [1, 0, 0]], "stiffness": 1, "rest": 1},
      {"energy": "stretch", "positions": [[0, 0, 0], [1, 0]], "rest": 1}]})")});
  CHECK(result.exit_code == 2);
  CHECK(result.output.empty());
  for (const char* part : {"/cases/0/energy: there is no energy 'strech'; did you mean 'stretch'",
                           "/cases/1/positions: expected 3 positions, found 2",
                           "/cases/2/positions/1: expected", "/cases/2/stiffness: missing"}) {
    CHECK_THAT(result.errors, Catch::Contains(part));
  }
  CHECK(place.run({"eval", "none.json"}).exit_code == 2);
  CHECK(place.run({"eval", place.write("list.json", "[1]")}).exit_code == 2);
  const ProgramResult filter =
      place.run({"eval", place.write("c.json", cases), "--filter", "tigth"});
  CHECK(filter.exit_code == 2);
  CHECK_THAT(filter.errors, Catch::Contains("tight"));
}
