#include "apps/overrides.h"
#include "tests/catch.h"

using namespace ringlet;

namespace {

Json changed(const std::string& assignment) {
  Json scene = Json::parse(R"({"run": {"steps": 3}, "energies": ["stretch", {"type": "bending"}],
                               "a/b": 1})");
  apply_override(scene, assignment);
  return scene;
}

}  // namespace

TEST_CASE("the option --set changes entries, makes missing ones, and takes JSON or text") {
  CHECK(changed("/run/steps=7")["run"]["steps"] == 7);
  CHECK(changed("/energies/1/filter=exact")["energies"][1]["filter"] == "exact");
  CHECK(changed("/solver=pcg")["solver"] == "pcg");
  CHECK(changed("/solver/preconditioner/type=\"jacobi\"")["solver"]["preconditioner"]["type"] ==
        "jacobi");
  CHECK(changed("/about=a = b")["about"] == "a = b");
  CHECK(changed("/collision=null")["collision"].is_null());
  CHECK(changed("/a~1b=2")["a/b"] == 2);
}

TEST_CASE("the option --set refuses what cannot be set") {
  using Catch::Matchers::Contains;
  CHECK_THROWS_WITH(changed("run/steps=7"), Contains("begins with '/'"));
  CHECK_THROWS_WITH(changed("/run/steps"), Contains("expected /pointer=value"));
  CHECK_THROWS_WITH(changed("/energies/2=twist"), Contains("no entry of a list of 2"));
  CHECK_THROWS_WITH(changed("/energies/x=twist"), Contains("no entry of a list of 2"));
  CHECK_THROWS_WITH(changed("/run/steps/x=1"), Contains("no object or list"));
  CHECK_THROWS_WITH(changed("/a~2=1"), Contains("followed by 0 or 1"));
}
