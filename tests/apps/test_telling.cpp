#include "tests/apps/program.h"
#include "tests/catch.h"

using namespace ringlet;

namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("list names the plugins, all or of one kind") {
  const Workplace place;
  const std::string all = place.run({"list"}).output;
  for (const char* part : {"energy\n", "  twist ", "linear solver\n", "  pcg ", "  vtp "}) {
    CHECK(contains(all, part));
  }
  for (const char* kind : {"linear solver", "linear-solver", "solver"}) {
    const ProgramResult solvers = place.run({"list", kind});
    CHECK(solvers.exit_code == 0);
    CHECK(contains(solvers.output, "pcg"));
    CHECK_FALSE(contains(solvers.output, "twist"));
  }
  const ProgramResult none = place.run({"list", "slover"});
  CHECK(none.exit_code == 2);
}

TEST_CASE("describe tells a plugin's keys and the scene's") {
  const Workplace place;
  const std::string vtp = place.run({"describe", "vtp"}).output;
  CHECK(contains(vtp, "vtp (writer)"));
  CHECK(contains(vtp, "every              integer >= 1; default 1"));
  const std::string twist = place.run({"describe", "twist"}).output;
  CHECK(contains(twist, "equation: "));
  CHECK(contains(twist, "source: "));
  CHECK(contains(place.run({"describe", "scene"}).output, "strands            strand source"));
  const ProgramResult none = place.run({"describe", "twsit"});
  CHECK(none.exit_code == 2);
  CHECK(contains(none.errors, "did you mean 'twist'"));
}

TEST_CASE("help, version and check") {
  const Workplace place;
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"help"}, {"--help"}, {"run", "--help"}}) {
    const ProgramResult help = place.run(words);
    CHECK(help.exit_code == 0);
    CHECK(contains(help.output, "ringlet run [SCENE.json]"));
    CHECK(contains(help.output, "Exit codes"));
  }
  CHECK(contains(place.run({"--version"}).output, "ringlet 0."));
  const ProgramResult check = place.run({"check", place.write("s.json", small_scene().dump())});
  CHECK(check.exit_code == 0);
  CHECK(contains(check.output, "20 of 300 vertices in all, 80 of them pinned (helix)"));
}
