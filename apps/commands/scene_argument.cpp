#include "apps/commands/scene_argument.h"

#include <algorithm>

#include "apps/overrides.h"
#include "apps/report/run_source.h"
#include "core/load_plugin.h"
#include "plugins/render/render_parameters.h"

namespace ringlet {

std::vector<Option> scene_options() {
  return {{.name = "--set",
           .value = "/pointer=value",
           .meaning = "change an entry of the scene; may be repeated",
           .repeatable = true},
          {.name = "--steps", .value = "N", .meaning = "instead of the scene's number of steps"}};
}

namespace {

/// The scene names all that is loaded, so that what is written of it runs again as it is.
void name_plugins(Json& scene, const Registry& registry) {
  Json& plugins = scene["plugins"];
  const bool is_readable =
      plugins.is_null() ||
      (plugins.is_array() &&
       std::all_of(plugins.begin(), plugins.end(), [](const Json& p) { return p.is_string(); }));
  if (is_readable) plugins = registry.libraries();
}

void change_steps(Scene& scene, const Arguments& arguments) {
  if (const auto steps = arguments.integer("--steps", 0)) scene.run.steps = *steps;
}

/// Completes the entry "render", which core does not know. Appends what is wrong with it.
void complete_look(Json& scene, const Registry& registry, std::vector<Problem>& problems) {
  if (!scene.is_object() || !scene.contains("render") || !scene["render"].is_object()) return;
  try {
    const RenderParameters parameters = read_render_parameters(scene["render"], registry);
    scene["render"] = RenderParameters::schema().write(parameters);
  } catch (const InvalidInput& error) {
    problems = error.problems();
  }
}

/// Tells all problems at once, those of the entry "render", too.
Scene read_whole_scene(Json json, const Registry& registry, const std::filesystem::path& folder) {
  std::vector<Problem> problems;
  complete_look(json, registry, problems);
  std::optional<Scene> scene;
  try {
    scene = read_scene(json, registry, folder);
  } catch (const InvalidInput& error) {
    problems.insert(problems.begin(), error.problems().begin(), error.problems().end());
  }
  if (!problems.empty()) throw InvalidInput(std::move(problems));
  return std::move(*scene);
}

}  // namespace

Scene read_scene_argument(Registry& registry, const Arguments& arguments) {
  const std::filesystem::path path = *arguments.operand(0);
  Json json = load_json(path);
  for (const std::string& assignment : arguments.values("--set")) apply_override(json, assignment);
  load_plugins_of(json, path.parent_path(), registry);
  if (json.is_object()) name_plugins(json, registry);
  Scene scene = read_whole_scene(json, registry, path.parent_path());
  change_steps(scene, arguments);
  return scene;
}

Scene read_scene_of_run(const std::filesystem::path& folder, Registry& registry,
                        const Arguments& arguments) {
  const Json json = load_scene_of_run(folder);
  load_plugins_of(json, folder, registry);
  Scene scene = read_scene(json, registry, folder);
  change_steps(scene, arguments);
  return scene;
}

}  // namespace ringlet
