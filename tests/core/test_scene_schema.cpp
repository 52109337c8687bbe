// That scenes are judged by it as by read_scene() is tried in tests/apps/schema/.

#include "core/direction.h"
#include "core/energy.h"
#include "core/linear_solver.h"
#include "core/modules.h"
#include "core/scene_schema.h"
#include "tests/catch.h"

using namespace ringlet;

namespace {

enum class Side { left, right };

}  // namespace

template <>
struct ringlet::EnumNames<Side> {
  static constexpr std::pair<Side, const char*> names[] = {{Side::left, "left"},
                                                           {Side::right, "right"}};
};

namespace {

struct Sample {
  double size = 2;
  int count = 3;
  Side side = Side::right;
  std::optional<double> share;
  std::vector<std::string> words;
  Direction axis;
  std::optional<Choice<LinearSolver>> solver;

  static Schema<Sample> schema() {
    return Schema<Sample>()
        .required("size", &Sample::size, "m", positive(), "of it")
        .key("count", &Sample::count, "", at_least(0), "of them")
        .key("side", &Sample::side, "", any_number(), "where")
        .key("share", &Sample::share, "", between(0, 1), "of all")
        .key("words", &Sample::words, "", any_number(), "for it")
        .key("axis", &Sample::axis, "", any_number(), "of it")
        .key("solver", &Sample::solver, "", any_number(), "within");
  }
};

}  // namespace

TEST_CASE("a declaration of keys is told as a JSON Schema") {
  CHECK(object_schema(Sample::schema().infos()) == Json::parse(R"({
    "type": "object",
    "properties": {
      "size": {"type": "number", "exclusiveMinimum": 0.0, "description": "of it [m]"},
      "count": {"type": "integer", "minimum": 0.0, "description": "of them", "default": 3},
      "side": {"enum": ["left", "right"], "description": "where", "default": "right"},
      "share": {"anyOf": [{"type": "number", "minimum": 0.0, "maximum": 1.0}, {"type": "null"}],
                "description": "of all", "default": null},
      "words": {"type": "array", "items": {"type": "string"}, "description": "for it",
                "default": []},
      "axis": {"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3,
               "not": {"const": [0, 0, 0]}, "description": "of it", "default": [0.0, 1.0, 0.0]},
      "solver": {"anyOf": [{"$ref": "#/$defs/linear_solver"}, {"const": "none"}, {"type": "null"}],
                 "description": "within", "default": null}
    },
    "required": ["size"],
    "additionalProperties": false
  })"));
}

TEST_CASE("the schema of a scene knows the plugins that are loaded, and those alone") {
  Registry registry;
  CHECK(scene_schema(registry)["$defs"]["energy"] == false);
  registry.of<Energy>().add<NoParameters>("soft", {"a soft one", "", ""},
                                          [](const NoParameters&) { return nullptr; });
  registry.of<Energy>().add<Sample>("sized", {"a sized one", "", ""},
                                    [](const Sample&) { return nullptr; });
  const Json schema = scene_schema(registry);
  CHECK(schema["required"] == Json::array({"strands"}));
  const Json& energies = schema["$defs"]["energy"]["anyOf"];
  REQUIRE(energies.size() == 3);
  // By its name alone only what needs no key.
  CHECK(energies[0] == Json{{"const", "soft"}, {"description", "a soft one"}});
  CHECK(energies[1]["properties"]["type"] == Json{{"const", "soft"}});
  CHECK(energies[2]["required"] == Json::array({"type", "size"}));
}
