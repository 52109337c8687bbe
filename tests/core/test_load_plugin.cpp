#include <cstdlib>

#include "core/contact_energy.h"
#include "core/load_plugin.h"
#include "core/plugin.h"
#include "core/read_choice.h"
#include "tests/catch.h"
#include "tests/temporary_file.h"

using namespace ringlet;

namespace {

std::string library(const std::string& name) { return RINGLET_LOADED "/" + name + ".so"; }

std::string refusal(const std::string& plugin) {
  Registry registry;
  try {
    load_plugin(plugin, ".", registry);
  } catch (const Error& error) {
    CHECK(registry.of<ContactEnergy>().names().empty());
    CHECK(registry.libraries().empty());
    return error.what();
  }
  FAIL(plugin << " was not refused");
  return "";
}

}  // namespace

TEST_CASE("a plugin library adds what it offers, and is loaded once") {
  Registry registry;
  load_plugin(library("right"), ".", registry);
  load_plugin(library("right"), "elsewhere", registry);
  REQUIRE(registry.of<ContactEnergy>().names() == std::vector<std::string>{"nothing"});
  CHECK(registry.of<ContactEnergy>().find("nothing")->library == library("right"));
  CHECK(registry.libraries() == std::vector<std::string>{library("right")});
  CHECK(make_chosen<ContactEnergy>(registry, "nothing")->at(1, 2, 3).value == 0);
}

TEST_CASE("a plugin is found by its name in the folders of the search path") {
  Registry registry;
  unsetenv("RINGLET_PLUGIN_PATH");
  CHECK_THAT(refusal("right"), Catch::Contains("RINGLET_PLUGIN_PATH (not set)"));
  setenv("RINGLET_PLUGIN_PATH", "/nowhere:" RINGLET_LOADED, 1);
  load_plugin("right", ".", registry);
  CHECK(registry.of<ContactEnergy>().find("nothing") != nullptr);
  CHECK_THAT(refusal("wrong"), Catch::Contains("no plugin 'wrong'") && Catch::Contains("/nowhere"));
  unsetenv("RINGLET_PLUGIN_PATH");
}

TEST_CASE("what is no plugin, or does not fit, is refused with the reason") {
  CHECK_THAT(refusal("./not_there.so"), Catch::Contains("not_there.so"));
  CHECK_THAT(refusal(library("no_plugin")), Catch::Contains("it is no plugin"));
  CHECK_THAT(refusal(library("outdated")),
             Catch::Contains("ringlet 0.0.9, this program with " + std::string(version)));
  CHECK_THAT(refusal(library("incomplete")), Catch::Contains("written_nowhere"));
  CHECK_THAT(refusal(library("throwing")), Catch::Contains("out of ideas"));
  CHECK_THAT(refusal(library("twice")), Catch::Contains("two plugins") &&
                                            Catch::Contains("'nothing'") &&
                                            Catch::Contains("twice.so"));
  const TemporaryFile text("so", "not a library");
  CHECK_THAT(refusal(text.path().string()), Catch::Contains("cannot load the plugin"));
}

TEST_CASE("stamps that differ anywhere do not fit") {
  CHECK(difference(this_build).empty());
  PluginStamp stamp = this_build;
  stamp.lanes = 3;
  CHECK_THAT(difference(stamp), Catch::Contains("doubles: 3"));
  stamp = this_build;
  stamp.eigen_alignment = 64;
  CHECK_THAT(difference(stamp), Catch::Contains("EIGEN_MAX_ALIGN_BYTES 64"));
  stamp = this_build;
  stamp.compiler = "another";
  CHECK_THAT(difference(stamp), Catch::Contains("compiler another"));
}

TEST_CASE("plugins of a scene that cannot be loaded are told with their pointers") {
  Registry registry;
  const Json scene{{"plugins", {library("right"), "./missing.so", 3, library("throwing")}}};
  try {
    load_plugins_of(scene, "/folder", registry);
    FAIL("nothing was refused");
  } catch (const InvalidInput& error) {
    REQUIRE(error.problems().size() == 2);
    CHECK(error.problems()[0].pointer == "/plugins/1");
    CHECK_THAT(error.problems()[0].message, Catch::Contains("/folder/missing.so"));
    CHECK(error.problems()[1].pointer == "/plugins/3");
  }
  CHECK(registry.libraries().size() == 1);
}
