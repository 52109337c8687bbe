#include "core/scene.h"
#include "tests/catch.h"
#include "tests/temporary_file.h"

using namespace ringlet;

namespace {

std::string problems_of(const std::string& text) {
  const Registry registry;
  try {
    read_scene(Json::parse(text), registry, ".");
  } catch (const InvalidInput& invalid) {
    return invalid.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a scene that names unknown things says so for each of them") {
  const std::string problems = problems_of(
      R"({"strands": [], "energies": ["benting"], "run": {"stepz": 3}, "materials": {},
          "material": {"density": -1}, "solver": {"kind": "pcg"}, "integrator": 3})");
  INFO(problems);
  for (const char* pointer : {"/strands: ", "/energies/0/type: ", "/run/stepz: ", "/materials: ",
                              "/material/density: ", "/solver: ", "/integrator: "}) {
    CHECK(problems.find(pointer) != std::string::npos);
  }
  CHECK(problems.find("7 problems") == 0);
}

TEST_CASE("JSON that is not JSON is refused with its place") {
  const TemporaryFile broken("json", "{\n  \"a\": 1,\n  \"b\" 2\n}");
  CHECK_THROWS_WITH(load_json(broken.path()), contains("line 3"));
  CHECK_THROWS_WITH(load_json("no/such/scene.json"), contains("no/such/scene.json"));
}

TEST_CASE("a key that stands twice is refused, not silently overwritten") {
  const TemporaryFile twice("json", R"({"run": {"steps": 1, "steps": 2}})");
  CHECK_THROWS_WITH(load_json(twice.path()), contains("'steps' stands twice"));
  const TemporaryFile separate("json", R"({"a": {"steps": 1}, "b": {"steps": 2}})");
  CHECK_NOTHROW(load_json(separate.path()));
}

TEST_CASE("comments are allowed in a scene") {
  const TemporaryFile commented("json", "{ // why\n \"a\": /* what */ 1}");
  CHECK(load_json(commented.path())["a"] == 1);
}
