#include "apps/bench/table.h"
#include "apps/bench/timing.h"
#include "tests/apps/program.h"
#include "tests/catch.h"

using namespace ringlet;

TEST_CASE("tables show three digits and keep all of them in JSON") {
  const BenchTable table{"Speeds", {"what", "number"}, {{"a", 12345.6}, {"b", 0.012345}, {"c", 7}}};
  CHECK(as_markdown(table) ==
        "Speeds\n\n| what | number |\n| --- | --- |\n| a | 12346 |\n| b | 0.0123 |\n| c | 7 |\n");
  CHECK(as_json(table)["rows"][1] == Json{{"what", "b"}, {"number", 0.012345}});
}

TEST_CASE("a measurement warms up, repeats and takes the median") {
  int calls = 0;
  const Timing timing = measure([&] { ++calls; }, 1e-3);
  CHECK(calls > 5);
  CHECK(timing.median >= 0);
  CHECK(timing.spread >= 0);
  calls = 0;
  measure([&] { ++calls; }, 0);
  CHECK(calls == 1);
}

TEST_CASE("every benchmark runs") {
  const Workplace place;
  const ProgramResult result = place.run({"bench", "--quick", "--json", "figures.json"});
  CHECK(result.exit_code == 0);
  CHECK_THAT(result.output, Catch::Contains("| twist | gauss_newton |"));
  const Json figures = Json::parse(read_text(place.folder() / "figures.json"));
  CHECK(figures["threads"] >= 1);
  for (const Json& table : figures["tables"]) {
    INFO(table["title"]);
    REQUIRE_FALSE(table["rows"].empty());
  }
  const ProgramResult unknown = place.run({"bench", "filers"});
  CHECK(unknown.exit_code == 2);
  CHECK_THAT(unknown.errors, Catch::Contains("did you mean 'filters'"));
}
