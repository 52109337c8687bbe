#include "core/registry.h"
#include "core/strands.h"
#include "core/varying.h"
#include "tests/catch.h"
#include "tests/temporary_file.h"

using namespace ringlet;

namespace {

struct WithNumber {
  Varying number = 2.0;
  static Schema<WithNumber> schema() {
    return Schema<WithNumber>().key("number", &WithNumber::number, "N", at_least(0), "for tests");
  }
};

struct Reading {
  WithNumber sample;
  std::vector<Problem> problems;
};

Reading read(const Json& number) {
  Registry registry;
  Reading result;
  ParseContext context{registry, "/", {}, result.problems};
  WithNumber::schema().read({{"number", number}}, "/here", context, result.sample);
  return result;
}

std::string problem(const Json& number) {
  const Reading result = read(number);
  REQUIRE(result.problems.size() == 1);
  return result.problems[0].pointer + ": " + result.problems[0].message;
}

/// Two strands: the vertices of the second are 1 m and 3 m apart.
Strands two_strands(const MaterialField& material = {}) {
  return {{2, 3}, {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {1, 4, 0}}, material};
}

std::vector<double> values(const Varying& number, const Strands& strands) {
  std::vector<double> all;
  for (int v = 0; v < strands.vertex_count(); ++v) all.push_back(number.at(strands, v));
  return all;
}

std::vector<double> values(const Json& number) {
  const Reading result = read(number);
  REQUIRE(result.problems.empty());
  return values(result.sample.number, two_strands());
}

}  // namespace

TEST_CASE("a parameter may vary by strand, by vertex and along each strand") {
  using Values = std::vector<double>;
  CHECK(values(Json(3.5)) == Values{3.5, 3.5, 3.5, 3.5, 3.5});
  CHECK(values({{"by_strand", {1, 2}}}) == Values{1, 1, 2, 2, 2});
  CHECK(values({{"by_vertex", {1, 2, 3, 4, 5}}}) == Values{1, 2, 3, 4, 5});
  CHECK(values({{"root_to_tip", {1, 3}}}) == Values{1, 3, 1, 1.5, 3});
  CHECK(values({{"root_to_tip", {1, 3, 11}}}) == Values{1, 11, 1, 2, 11});
}

TEST_CASE("the numbers of a parameter may stand in a file") {
  const TemporaryFile file("txt", "# of two strands\n1.5, 2.5  # the second\n");
  const Json number{{"by_strand", file.path().string()}};
  CHECK(values(number) == std::vector<double>{1.5, 1.5, 2.5, 2.5, 2.5});
  CHECK(WithNumber::schema().write(read(number).sample)["number"] == number);
  const TemporaryFile wrong("txt", "1\n2 three\n"), negative("txt", "1 2\n-3");
  CHECK_THAT(problem({{"by_strand", wrong.path().string()}}),
             Catch::Contains("line 2: expected a number, found 'three'"));
  CHECK_THAT(problem({{"by_strand", negative.path().string()}}),
             Catch::Contains("expected numbers >= 0, but number 3") && Catch::Contains("is -3"));
  CHECK_THAT(problem({{"by_strand", "/none.txt"}}), Catch::Contains("there is no file"));
}

TEST_CASE("what a parameter varies by is checked") {
  CHECK_THAT(problem(-1), Catch::StartsWith("/here/number: expected number >= 0 in N, found -1"));
  CHECK_THAT(problem({{"by_strand", {1, -2}}}), Catch::Contains("/here/number/by_strand/1"));
  CHECK_THAT(problem({{"by_hair", {1, 2}}}), Catch::Contains("by_strand"));
  CHECK_THAT(problem({{"by_strand", {1}}, {"by_vertex", {1}}}), Catch::Contains("by_strand"));
  CHECK_THAT(problem({{"root_to_tip", {1}}}), Catch::Contains("at least 2 numbers"));
  CHECK_THROWS_WITH(values({{"by_strand", {1, 2, 3}}}),
                    "/here/number: expected 2 numbers, one for each strand, found 3");
  CHECK_THROWS_WITH(values({{"by_vertex", {1, 2, 3}}}),
                    "/here/number: expected 5 numbers, one for each vertex, found 3");
}

TEST_CASE("a material may vary") {
  MaterialField material;
  material.radius = read({{"root_to_tip", {1e-3, 2e-3}}}).sample.number;
  material.density = read({{"by_strand", {1000, 500}}}).sample.number;
  const Strands strands = two_strands(material);
  CHECK(strands.radius(0) == 1e-3);
  CHECK(strands.radius(3) == Approx(1.25e-3));
  CHECK(strands.mass(0) == Approx(1000 * circle_area(1e-3) * 0.5));
  CHECK(strands.mass(3) == Approx(500 * circle_area(1.25e-3) * 2));
}

TEST_CASE("the echo of a material tells what one number says, and derives nothing else") {
  Registry registry;
  std::vector<Problem> problems;
  ParseContext context{registry, "/", {}, problems};
  const auto echo = [&](const Json& json) {
    MaterialField material;
    MaterialField::schema().read(json, "/material", context, material);
    return MaterialField::schema().write(material);
  };
  const Json plain = echo({{"youngs_modulus", 6.0}, {"poisson_ratio", 0.5}, {"radius", 2.0}});
  CHECK(plain["shear_modulus"] == 2.0);
  CHECK(plain["tip_radius"] == 2.0);
  const Json varying =
      echo({{"youngs_modulus", {{"by_strand", {6, 7}}}}, {"radius", {{"root_to_tip", {2, 1}}}}});
  CHECK(varying["shear_modulus"].is_null());
  CHECK(varying["tip_radius"].is_null());
  CHECK(problems.empty());
}

TEST_CASE("a radius that varies along the strands has no other taper") {
  Registry registry;
  std::vector<Problem> problems;
  ParseContext context{registry, "/", {}, problems};
  MaterialField material;
  MaterialField::schema().read({{"radius", {{"root_to_tip", {1, 2}}}}, {"tip_radius", 1}},
                               "/material", context, material);
  REQUIRE(problems.size() == 1);
  CHECK(problems[0].pointer == "/material/tip_radius");
}
