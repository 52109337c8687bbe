// Draws frames of a run as pictures, without a display.

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>
#include <tbb/global_control.h>

#include <chrono>

#include "apps/commands/command.h"
#include "apps/exit_codes.h"
#include "apps/overrides.h"
#include "apps/render/chosen_frames.h"
#include "apps/render/video.h"
#include "core/json_file.h"
#include "core/load_plugin.h"
#include "plugins/render/run_scenery.h"

namespace ringlet {
namespace {

namespace fs = std::filesystem;

/// The scene of a run; an empty one for a folder that has only frames.
Json read_scene_of(const fs::path& folder, Registry& registry) {
  const Json scene = load_json_if_there(folder / "scene.resolved.json");
  if (scene.is_null()) return Json::object();
  try {
    load_plugins_of(scene, folder, registry);
  } catch (const InvalidInput& error) {
    // Colliders may follow motions of plugins; a picture does without them if it must.
    spdlog::warn("{}", error.what());
  }
  return scene;
}

/// The entry "render" of the scene, with changes.
RenderParameters read_parameters(const Json& scene, const Arguments& arguments,
                                 const Registry& registry) {
  Json look{{"render", Json::object()}};
  if (scene.contains("render") && !scene["render"].is_null()) look["render"] = scene["render"];
  for (const std::string& change : arguments.values("--set")) {
    apply_override(look, change);
    if (look.size() == 1) continue;
    throw Error("--set '" + change + "': expected a pointer that begins with /render/");
  }
  return read_render_parameters(look["render"], registry);
}

/// One picture has the name that was asked for, each of several its step in it.
fs::path name_of_picture(const fs::path& wanted, int step, bool only) {
  if (only) return wanted;
  const std::string name =
      fmt::format("{}_{:05}{}", wanted.stem().string(), step, wanted.extension().string());
  return wanted.parent_path() / name;
}

/// Returns the files.
std::vector<fs::path> draw_all(RunScenery& scenery, const RenderParameters& parameters,
                               const fs::path& wanted) {
  std::vector<fs::path> files;
  for (int i = 0; i < scenery.count(); ++i) {
    const auto begin = std::chrono::steady_clock::now();
    const fs::path path = name_of_picture(wanted, scenery.step(i), scenery.count() == 1);
    write_png(draw(scenery.subject(i), scenery.camera(), scenery.up(), parameters), path);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
    spdlog::info("frame {}: {:.1f} s", scenery.step(i), taken.count());
    fmt::print("{}\n", path.string());
    files.push_back(path);
  }
  return files;
}

int render(Registry& registry, const Arguments& arguments) {
  const fs::path folder = *arguments.operand(0);
  const auto video = arguments.value("--video");
  std::optional<tbb::global_control> threads;
  if (const auto count = arguments.integer("--threads", 1)) {
    threads.emplace(tbb::global_control::max_allowed_parallelism, *count);
  }
  require_renderer();
  if (video) require_ffmpeg();
  const Json scene = read_scene_of(folder, registry);
  const RenderParameters parameters = read_parameters(scene, arguments, registry);
  RunFrames frames(folder);
  for (const std::string& reason : frames.left_out()) spdlog::warn("left out: {}", reason);
  RunScenery scenery(
      frames,
      chosen_frames(frames.steps(), arguments.integer("--frame", 0), arguments.value("--frames")),
      scene, parameters, registry);
  for (const std::string& note : scenery.notes()) spdlog::warn("{}", note);
  const fs::path wanted = arguments.value("--output").value_or((folder / "render.png").string());
  const std::vector<fs::path> pictures = draw_all(scenery, parameters, wanted);
  if (video) {
    make_video(pictures, scenery.seconds_each(), *video);
    fmt::print("{}\n", *video);
  }
  return exit_ok;
}

}  // namespace

Command render_command() {
  return {"render",
          {"DIR"},
          "draws frames of a run by ray tracing, as PNG files or a video",
          {{.name = "--frame", .value = "N", .meaning = "step of the frame, the last if absent"},
           {.name = "--frames",
            .value = "A:B[:EVERY]",
            .meaning = "frames from step A to B, all or one in EVERY; OUT_00012.png, ..."},
           {.name = "--output",
            .value = "OUT.png",
            .meaning = "DIR/render.png if absent",
            .short_name = "-o"},
           {.name = "--video", .value = "FILE.mp4", .meaning = "also a video of them, by ffmpeg"},
           {.name = "--set",
            .value = "/render/key=value",
            .meaning = "changes how it looks: see `ringlet describe render`; may be repeated",
            .repeatable = true},
           {.name = "--threads", .value = "N", .meaning = "all cores if absent"}},
          render};
}

}  // namespace ringlet
