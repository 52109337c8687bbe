#include <cmath>

#include "apps/validate/validation.h"
#include "tests/apps/program.h"
#include "tests/catch.h"

using namespace ringlet;

TEST_CASE("the quick part of the validation passes, and says what it compared") {
  const Workplace place;
  const ProgramResult result = place.run({"validate", "--quick", "--json", "rows.json"});
  CAPTURE(result.output, result.errors);
  CHECK(result.exit_code == 0);
  const Json rows = Json::parse(read_text(place.folder() / "rows.json"))["rows"];
  for (const ValidationCase& one : all_validation_cases()) {
    CAPTURE(one.name);
    CHECK(result.output.find(std::string("| ") + one.name + " |") != std::string::npos);
  }
  CHECK(count_lines(result.output) == 2 + static_cast<int>(rows.size()));
  for (const Json& row : rows) CHECK(row["passes"] == true);
}

TEST_CASE("a wrong value, and an order that is too low, do not pass") {
  ValidationRow row{"case", "quantity", 2, 2.1, 0.04};
  CHECK(row.error() == Approx(0.05));
  CHECK_FALSE(row.passes());
  row.tolerance = 0.06;
  CHECK(row.passes());
  row.least_order = 1.8;
  CHECK_FALSE(row.passes());
  row.order = 1.9;
  CHECK(row.passes());
  row.measured = std::nan("");
  CHECK_FALSE(row.passes());
  CHECK(ValidationRow{"", "", 0, 1e-3, 1e-2}.passes());
}

TEST_CASE("a case that does not exist is refused") {
  const Workplace place;
  const ProgramResult result = place.run({"validate", "cantilver"});
  CHECK(result.exit_code == 2);
  CHECK_THAT(result.errors, Catch::Contains("did you mean 'cantilever'"));
}
