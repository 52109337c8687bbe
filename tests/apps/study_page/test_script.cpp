#include <regex>

#include "apps/study/picture/script.h"
#include "apps/study/picture/symbols.h"
#include "tests/apps/study_page/sample_results.h"
#include "tests/catch.h"

using namespace ringlet;

namespace {

/// What gnuplot reads as commands: all but its strings.
std::string without_strings(const std::string& script) {
  return std::regex_replace(script, std::regex("'([^'\n]|'')*'"), "");
}

/// Rows of a block of data.
std::vector<std::string> rows_of(const std::string& script, const std::string& block) {
  std::istringstream lines(script);
  std::vector<std::string> rows;
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line == "end_of_data") inside = false;
    if (inside) rows.push_back(line);
    if (line == "$" + block + " << end_of_data") inside = true;
  }
  return rows;
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("The picture of a study has a point for what ran and words for the rest") {
  const std::string script = picture_script(sample_results());
  const auto points = rows_of(script, "points");
  REQUIRE(points.size() == 3);
  const std::string hollow = " " + std::to_string(symbol_for(1, false)) + " 0x";
  const std::string filled = " " + std::to_string(symbol_for(1, true)) + " 0x";
  CHECK(points[0].starts_with("0.5 0.004 0.45 0.6"));
  CHECK(has(points[0], hollow));
  CHECK(has(points[2], filled));
  CHECK(points[0].substr(points[0].find("0x")) != points[2].substr(points[2].find("0x")));
  CHECK(rows_of(script, "front").size() == 3);
  CHECK(rows_of(script, "spread").size() == 3);
  CHECK(rows_of(script, "default") == std::vector{points[2]});
  CHECK(has(script, "wild (exploded: a vertex flew away)"));
  CHECK(has(script, "odd (refused: /solver: expected one of ''pcg'')"));
  CHECK(has(script, "'mean distance'"));
  CHECK(has(script, "'1.5 s, 1 mm'"));
}

TEST_CASE("Names in the picture of a study are no commands of gnuplot") {
  Json results = sample_results();
  const std::string hostile = "'; system('harm') #\nharm `harm` \"harm\" @harm $harm \\";
  results["study"] = {{"name", hostile}, {"about", hostile}, {"scene", hostile}};
  results["timing_note"] = results["default"] = hostile;
  results["variants"][0]["name"] = results["fronts"]["mean_distance"][0] = hostile;
  results["variants"][4]["reason"] = hostile;
  results["errors"][0]["label"] = results["errors"][0]["unit"] = hostile;
  for (const char* key : {"label", "unit"}) results["axes"][0][key] = hostile;
  results["axes"][0]["values"][0] = hostile;
  const std::string script = picture_script(results);
  CHECK(has(script, "harm"));
  CHECK(!has(without_strings(script), "harm"));
  CHECK(!has(without_strings(script), "'"));
}

TEST_CASE("Of a long front some points bear numbers, which keep away from each other") {
  Json results = sample_results();
  results["variants"] = results["fronts"]["mean_distance"] = Json::array();
  for (int i = 0; i < 300; ++i) {
    const std::string name = "v" + std::to_string(i);
    results["variants"].push_back(sample_variant(name, 1 + 1e-6 * i, 1e-3 - 1e-9 * i));
    results["fronts"]["mean_distance"].push_back(name);
  }
  const std::string script = picture_script(results);
  CHECK(rows_of(script, "front").size() == 300);
  const std::regex number("set label '(\\d+)' at screen ([0-9.]+),([0-9.]+) .* front");
  std::vector<std::array<double, 2>> places;
  for (auto match = std::sregex_iterator(script.begin(), script.end(), number);
       match != std::sregex_iterator(); ++match) {
    places.push_back({1400 * std::stod((*match)[2]), 900 * std::stod((*match)[3])});
  }
  REQUIRE(places.size() == 12);
  for (std::size_t i = 1; i < places.size(); ++i) {
    CHECK(std::hypot(places[i][0] - places[i - 1][0], places[i][1] - places[i - 1][1]) > 15);
  }
  CHECK(has(script, "'v0'"));
  CHECK(has(script, "'v299'"));
}

TEST_CASE("Without a reference the picture of a study shows Newton iterations") {
  Json results = sample_results();
  results.erase("reference");
  results["errors"] = results["fronts"] = Json();
  results["errors"] = Json::array();
  results["fronts"] = Json::object();
  const std::string script = picture_script(results);
  CHECK(has(script, "'Newton iterations a step'"));
  CHECK(rows_of(script, "points").size() == 3);
  CHECK(rows_of(script, "front").empty());
}

TEST_CASE("An error of zero stands on the lower edge of the picture, and a word says so") {
  Json results = sample_results();
  results["variants"].erase(4);
  results["variants"].erase(3);
  results["variants"][2]["errors"]["mean_distance"] = 0;
  const std::string script = picture_script(results);
  CHECK(rows_of(script, "points").size() == 3);
  CHECK(has(script, "with zero: fine"));
}

TEST_CASE("The picture of a study in which nothing ran says so") {
  Json results = sample_results();
  results["variants"] = Json::array({results["variants"][4]});
  const std::string script = picture_script(results);
  CHECK(has(script, "No variant has a place"));
  CHECK(has(script, "odd (refused"));
}
