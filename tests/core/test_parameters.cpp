#include "core/parameters.h"
#include "core/registry.h"
#include "tests/catch.h"

using namespace ringlet;

namespace {

enum class Colour { red, green };

}  // namespace

template <>
struct ringlet::EnumNames<Colour> {
  static constexpr std::pair<Colour, const char*> names[] = {{Colour::red, "red"},
                                                             {Colour::green, "green"}};
};

namespace {

struct Inner {
  int count = 3;
  static Schema<Inner> schema() {
    return Schema<Inner>().key("count", &Inner::count, "", at_least(1), "how many");
  }
};

struct Sample {
  double length = 0.5;
  bool on = true;
  Eigen::Vector3d axis{0, 1, 0};
  Colour colour = Colour::green;
  std::optional<double> limit;
  std::vector<double> list{1, 2};
  std::string name;
  Inner inner;
  Inner included;

  static Schema<Sample> schema() {
    return Schema<Sample>()
        .key("length", &Sample::length, "m", positive(), "a length")
        .key("on", &Sample::on, "", any_number(), "a switch")
        .key("axis", &Sample::axis, "", any_number(), "a direction")
        .key("colour", &Sample::colour, "", any_number(), "a colour")
        .key("limit", &Sample::limit, "s", between(0, 1), "a limit")
        .key("list", &Sample::list, "", any_number(), "some numbers")
        .required("name", &Sample::name, "", any_number(), "a name")
        .key("inner", &Sample::inner, "", any_number(), "an object")
        .include(&Sample::included)
        .check([](Sample& sample, const std::string& pointer, ParseContext& context) {
          if (sample.name == "bad") context.problem(pointer_to(pointer, "name"), "is bad");
        });
  }
};

struct Reading {
  std::vector<Problem> problems;
  Sample sample;

  explicit Reading(const std::string& text) {
    const Registry registry;
    ParseContext context{registry, ".", {}, problems};
    Sample::schema().read(Json::parse(text), "/here", context, sample);
  }
  std::string messages() const {
    std::string all;
    for (const Problem& problem : problems) all += problem.pointer + ": " + problem.message + "\n";
    return all;
  }
};

}  // namespace

TEST_CASE("absent keys take the defaults of the struct, and the echo writes them out") {
  const Reading reading(R"({"name": "n"})");
  CHECK(reading.messages().empty());
  CHECK(Sample::schema().write(reading.sample).dump() ==
        R"({"length":0.5,"on":true,"axis":[0.0,1.0,0.0],"colour":"green","limit":null,)"
        R"("list":[1.0,2.0],"name":"n","inner":{"count":3},"count":3})");
}

TEST_CASE("what is given is read, and reading the echo gives the same again") {
  const Reading first(R"({"name": "n", "length": 2, "on": false, "axis": [1, 0, 0], "limit": 0.25,
                          "colour": "red", "list": [], "inner": {"count": 7}, "count": 9})");
  CHECK(first.messages().empty());
  CHECK(first.sample.length == 2);
  CHECK(first.sample.limit == 0.25);
  CHECK(first.sample.colour == Colour::red);
  CHECK(first.sample.inner.count == 7);
  CHECK(first.sample.included.count == 9);
  const Json echo = Sample::schema().write(first.sample);
  const Reading second(echo.dump());
  CHECK(Sample::schema().write(second.sample) == echo);
}

TEST_CASE("every problem is reported, with its pointer and what was expected") {
  const Reading reading(R"({"lenght": 1, "length": 0, "on": 1, "axis": [1, 2], "colour": "blue",
                            "limit": 3, "list": [1, "x"], "inner": {"count": 0.5}})");
  const std::string messages = reading.messages();
  INFO(messages);
  CHECK(reading.problems.size() == 9);
  const auto reported = [&](const std::string& line) {
    return messages.find(line) != std::string::npos;
  };
  CHECK(reported("/here/lenght: unknown key; did you mean 'length'?"));
  CHECK(reported("/here/length: expected number > 0 in m, found 0"));
  CHECK(reported("/here/on: expected true or false, found 1"));
  CHECK(reported("/here/axis: expected list of 3 numbers, found [1,2]"));
  CHECK(reported("/here/colour: expected one of 'red' 'green'"));
  CHECK(reported("/here/limit: expected number, or null in [0, 1] in s, found 3"));
  CHECK(reported("/here/list/1: expected list of number"));
  CHECK(reported("/here/inner/count: expected integer >= 1, found 0.5"));
  CHECK(reported("/here/name: missing; expected text: a name"));
}

TEST_CASE("checks of a schema run when its keys are right") {
  CHECK(Reading(R"({"name": "bad"})").messages() == "/here/name: is bad\n");
  CHECK(Reading(R"({"name": "bad", "length": -1})").problems.size() == 1);
}

TEST_CASE("an object is asked for where something else stands") {
  CHECK(Reading("3").messages() == "/here: expected an object {...}\n");
}

TEST_CASE("pointers are escaped") {
  CHECK(pointer_to("/a", std::string("b/c~d")) == "/a/b~1c~0d");
  CHECK(pointer_to("", 3) == "/3");
}
