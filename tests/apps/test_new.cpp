// That the project which `ringlet new` writes builds and runs is tried against an installed ringlet
// (consumer/test.cmake).

#include <regex>

#include "tests/apps/program.h"
#include "tests/catch.h"

using namespace ringlet;

namespace {

std::string undo(std::string text, const std::string& name, const std::string& example) {
  return std::regex_replace(text, std::regex(name), example);
}

}  // namespace

TEST_CASE("new writes a project under the wanted name") {
  const Workplace place;
  const ProgramResult result = place.run({"new", "energy", "stiff_bend", "here/it"});
  CHECK(result.exit_code == 0);
  CHECK_THAT(result.output, Catch::Contains("here/it"));
  const auto files = read_files(place.folder() / "here/it");
  REQUIRE(files.contains("stiff_bend.cpp"));
  CHECK_THAT(files.at("stiff_bend.cpp"),
             Catch::Contains("struct StiffBend") &&
                 Catch::Contains("RINGLET_PLUGIN(register_stiff_bend)"));
  for (const auto& [name, text] : files) CHECK_THAT(text, !Catch::Contains("chord_bend"));
}

TEST_CASE("new renames words of an example and nothing else") {
  const Workplace place;
  struct Project {
    const char *kind, *example, *type;
  };
  for (const Project& project :
       {Project{"solver", "conjugate_residual", "ConjugateResidual"},
        Project{"collider", "ring", "Ring"}, Project{"writer", "tip_track", "TipTrack"}}) {
    const std::string example = project.example, type = project.type;
    INFO(example);
    REQUIRE(place.run({"new", project.kind, "my_own", example}).exit_code == 0);
    const auto original = read_files(std::filesystem::path(RINGLET_EXAMPLES) / example);
    const auto files = read_files(place.folder() / example);
    CHECK(files.size() == original.size());
    for (const auto& [name, text] : files) {
      INFO(name);
      CHECK(undo(undo(text, "my_own", example), "MyOwn", type) ==
            original.at(undo(name, "my_own", example)));
      // A longer word that has the name in it.
      CHECK_FALSE(std::regex_search(text, std::regex("[A-Za-z]my_own|my_own[a-z]")));
      const std::regex forgotten("(^|[^a-z])" + example + "([^a-z]|$)|(^|[^A-Za-z])" + type +
                                 "([^a-z]|$)");
      CHECK_FALSE(std::regex_search(text, forgotten));
    }
  }
}

TEST_CASE("new refuses what it cannot write, and writes nothing then") {
  const Workplace place;
  const auto refusal = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "new");
    const ProgramResult result = place.run(arguments);
    CHECK(result.exit_code == 2);
    return result.errors;
  };
  CHECK_THAT(refusal({"enrgy", "a"}), Catch::Contains("energy"));
  CHECK_THAT(refusal({"energy", "Bend"}), Catch::Contains("'Bend' is no name"));
  CHECK_THAT(refusal({"energy", "../bend"}), Catch::Contains("is no name"));
  CHECK_THAT(refusal({"energy", "twist"}), Catch::Contains("'twist' (energy) already"));
  for (const char* folder : {"a", "Bend", "twist", "../bend"}) {
    CHECK_FALSE(std::filesystem::exists(place.folder() / folder));
  }
  place.write("kept.txt", "old");
  CHECK_THAT(refusal({"energy", "bend", "."}), Catch::Contains("not an empty folder"));
  CHECK_FALSE(std::filesystem::exists(place.folder() / "bend.cpp"));
}
