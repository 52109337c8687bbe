#include "apps/arguments.h"
#include "core/error.h"
#include "tests/catch.h"

using namespace ringlet;

namespace {

Arguments parse(const std::vector<std::string>& words) {
  return Arguments(words, {"SCENE", "[MORE]"},
                   {{.name = "--steps", .value = "N"},
                    {.name = "--output", .value = "DIR", .short_name = "-o"},
                    {.name = "--set", .value = "X", .repeatable = true},
                    {.name = "--quiet"}});
}

}  // namespace

TEST_CASE("options may stand anywhere and be spelt in each usual way") {
  const Arguments arguments =
      parse({"--steps", "3", "a.json", "-o", "out", "--set=/a=1", "--set", "/b=2", "--quiet"});
  CHECK(arguments.operand(0) == "a.json");
  CHECK_FALSE(arguments.operand(1));
  CHECK(arguments.integer("--steps", 0) == 3);
  CHECK(arguments.value("--output") == "out");
  CHECK(arguments.values("--set") == std::vector<std::string>{"/a=1", "/b=2"});
  CHECK(arguments.has("--quiet"));
  CHECK_FALSE(parse({"a.json"}).has("--quiet"));
  CHECK_FALSE(parse({"a.json"}).integer("--steps", 0));
}

TEST_CASE("what is wrong on a command line is refused, with what was meant") {
  using Catch::Matchers::Contains;
  CHECK_THROWS_WITH(parse({"a", "--stps", "3"}), Contains("did you mean '--steps'"));
  CHECK_THROWS_WITH(parse({"a", "--steps"}), Contains("needs a value: N"));
  CHECK_THROWS_WITH(parse({"a", "--steps", "1", "--steps", "2"}), Contains("twice"));
  CHECK_THROWS_WITH(parse({"a", "--quiet=yes"}), Contains("takes no value"));
  CHECK_THROWS_WITH(parse({}), Contains("missing SCENE"));
  CHECK_THROWS_WITH(parse({"a", "b", "c"}), Contains("unexpected 'c'"));
  for (const char* text : {"-1", "x", "3x", "", "1.5", "99999999999"}) {
    CHECK_THROWS_WITH(parse({"a", "--steps", text}).integer("--steps", 0),
                      Contains("expects an integer >= 0"));
  }
}
