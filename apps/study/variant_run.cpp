#include "apps/study/variant_run.h"

#include "apps/build_info.h"
#include "apps/exit_codes.h"
#include "apps/study/child_run.h"
#include "core/json_file.h"

namespace ringlet {
namespace {

namespace fs = std::filesystem;

/// Instead of what its scene writes, what is compared.
Json scene_to_run(const Variant& variant) {
  Json scene = variant.scene;
  scene["run"]["write"] = Json::array();
  scene["run"]["checkpoint_seconds"] = 0;
  if (variant.compare_every > 0) {
    scene["run"]["write"] = {
        {{"type", "frames"}, {"every", variant.compare_every}, {"precision", "double"}}};
  }
  return scene;
}

/// What a run must have been asked for to be this one.
Json request_of(const Variant& variant, int threads) {
  return {{"scene", scene_to_run(variant)}, {"threads", threads}, {"version", build_info::version}};
}

}  // namespace

fs::path variant_folder(const fs::path& study, const Variant& variant) {
  return study / "runs" / variant.folder;
}

std::vector<fs::path> run_variant(const Variant& variant, const RunSettings& settings) {
  const fs::path folder = variant_folder(settings.folder, variant);
  const Json request = request_of(variant, settings.threads);
  if (load_json_if_there(folder / "request.json") != request) fs::remove_all(folder);
  fs::create_directories(folder);
  write_json(folder / "request.json", request);
  const fs::path scene = folder / "scene.json";
  write_json(scene, request["scene"]);
  std::vector<fs::path> runs;
  for (int n = 1; n <= settings.repetitions; ++n) {
    const fs::path run = folder / std::to_string(n), outcome = run.string() + ".json";
    if (!fs::exists(outcome)) {
      fs::remove_all(run);
      const ChildOutcome ended = run_as_child(scene, run, settings.threads, settings.stop);
      if (ended.exit_code == exit_interrupted || settings.stop()) return runs;
      write_json(outcome, {{"exit_code", ended.exit_code}, {"message", ended.message}});
    }
    runs.push_back(run);
  }
  return runs;
}

}  // namespace ringlet
