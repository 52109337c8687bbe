#include "apps/commands/scene_argument.h"

#include "apps/overrides.h"

namespace ringlet {

std::vector<Option> scene_options() {
  return {{.name = "--set",
           .value = "/pointer=value",
           .meaning = "change an entry of the scene; may be repeated",
           .repeatable = true},
          {.name = "--steps", .value = "N", .meaning = "instead of the scene's number of steps"}};
}

Scene read_scene_argument(const Registry& registry, const Arguments& arguments) {
  const std::filesystem::path path = *arguments.operand(0);
  Json json = load_json(path);
  for (const std::string& assignment : arguments.values("--set")) apply_override(json, assignment);
  Scene scene = read_scene(json, registry, path.parent_path());
  if (const auto steps = arguments.integer("--steps", 0)) scene.run.steps = *steps;
  return scene;
}

}  // namespace ringlet
