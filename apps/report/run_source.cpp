#include "apps/report/run_source.h"

#include "core/error.h"

namespace ringlet {

namespace fs = std::filesystem;

Json load_scene_of_run(const fs::path& folder) {
  const fs::path path = folder / "scene.resolved.json";
  if (!fs::exists(path)) {
    throw Error("'" + folder.string() +
                "' is no folder of results; expected the folder that `ringlet run` names, with "
                "scene.resolved.json in it");
  }
  return load_json(path);
}

Json load_summary_of_run(const fs::path& folder) {
  return load_json_if_there(folder / "summary.json");
}

std::string name_of_run(const fs::path& folder) {
  const Json summary = load_summary_of_run(folder);
  if (summary.is_object() && summary.contains("scene")) return summary["scene"];
  return fs::absolute(folder / "x").parent_path().filename().string();
}

}  // namespace ringlet
