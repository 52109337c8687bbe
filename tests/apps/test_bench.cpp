#include <set>

#include "apps/bench/output.h"
#include "apps/bench/peak_memory.h"
#include "tests/apps/program.h"
#include "tests/catch.h"

using namespace ringlet;

TEST_CASE("a row is printed with three digits at once and kept with all of them") {
  std::string text;
  BenchOutput output([&text](const std::string& more) { text += more; });
  output.start_table(
      "Speeds",
      {{"what", "/parameters/what"}, {"ms", "/seconds", 1e-3}, {"contacts", "/contacts"}});
  output.add({.name = "speed", .parameters = {{"what", "a"}}, .time = Timing{12.3456, 0.5}});
  CHECK(text == "\nSpeeds\n\n| what | ms | contacts |\n| --- | --- | --- |\n| a | 12346 |  |\n");
  output.add(
      {.name = "speed", .parameters = {{"what", 7}}, .time = Timing{1.2345e-5, 0}, .contacts = 3});
  CHECK_THAT(text, Catch::EndsWith("| 7 | 0.0123 | 3.00 |\n"));
  CHECK(output.rows()[0] == Json{{"name", "speed"},
                                 {"parameters", {{"what", "a"}}},
                                 {"seconds", 12.3456},
                                 {"spread", 0.5}});
}

TEST_CASE("the peak of the memory is that of the function alone") {
  constexpr std::int64_t much = 64 << 20, little = 16 << 20;
  const auto use = [](std::int64_t bytes) {
    return peak_memory_during([&] { std::vector<char>(bytes, 1).shrink_to_fit(); });
  };
  const auto before = use(little), peak = use(much), after = use(little);
  if (!before || !peak || !after) return;
  CHECK(*peak > *before + much / 2);
#ifndef __SANITIZE_ADDRESS__  // which keeps what is freed for a while
  CHECK(*after < *peak - much / 2);
#endif
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
  std::set<std::string> names;
  for (const Json& row : figures["rows"]) {
    INFO(row);
    names.insert(row["name"]);
    CHECK(row["parameters"].is_object());
    if (row.contains("seconds")) CHECK(row["seconds"] > 0);
  }
  CHECK(names == std::set<std::string>{"elements", "filters/element", "filters/newton", "step",
                                       "step/baseline", "strand", "solvers", "tolerance",
                                       "collider", "limits/multiply_add", "limits/memory",
                                       "limits/cache", "limits/evaluate_factor_substitute"});
}

TEST_CASE("a benchmark refuses what it does not know") {
  const Workplace place;
  const ProgramResult unknown = place.run({"bench", "filers"});
  CHECK(unknown.exit_code == 2);
  CHECK_THAT(unknown.errors, Catch::Contains("did you mean 'filters'"));
  const ProgramResult unheeded = place.run({"bench", "strand", "--strands", "3", "--quick"});
  CHECK(unheeded.exit_code == 2);
  CHECK_THAT(unheeded.errors, Catch::Contains("'strand' has no option --strands"));
}

TEST_CASE("the largest hairball and the threads can be chosen") {
  const Workplace place;
  const ProgramResult result = place.run(
      {"bench", "step", "--quick", "--strands", "9", "--threads", "1", "--json", "figures.json"});
  CHECK(result.exit_code == 0);
  const Json rows = Json::parse(read_text(place.folder() / "figures.json"))["rows"];
  std::vector<std::string> names;
  for (const Json& row : rows) {
    names.push_back(row["name"]);
    CHECK(row["parameters"]["wisps"] == 9);
    CHECK(row["parameters"]["threads"] == 1);
    CHECK(row.contains("ratio") == (row["name"] == "step"));
    CHECK(row["stages"].contains("output") == (row["name"] == "step"));
  }
  CHECK(names == std::vector<std::string>{"step/baseline", "step", "step/baseline", "step/baseline",
                                          "step"});
}
