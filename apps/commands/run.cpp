#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>
#include <tbb/global_control.h>

#include "apps/checkpoint_file.h"
#include "apps/commands/command.h"
#include "apps/commands/scene_argument.h"
#include "apps/exit_codes.h"
#include "apps/report/run_source.h"
#include "apps/run_folder.h"
#include "apps/scene_run.h"

namespace ringlet {
namespace {

namespace fs = std::filesystem;

void warn_of_caps(const RunRecord& record) {
  if (record.newton_caps > 0) {
    spdlog::warn("Newton's method hit its iteration cap in {} of {} steps", record.newton_caps,
                 record.steps);
  }
  if (record.linear_caps > 0) {
    spdlog::warn("the linear solver did not converge in {} of {} steps", record.linear_caps,
                 record.steps);
  }
  if (record.error_caps > 0) {
    spdlog::warn(
        "even with the smallest time steps the local error was above the tolerance in {} of {} "
        "steps",
        record.error_caps, record.steps);
  }
}

void tell_expectations(const RunRecord& record) {
  for (const ExpectationResult& result : record.expectations) {
    if (!result.value) {
      spdlog::warn("not checked: {}", describe(result));
    } else if (result.met()) {
      spdlog::info("as expected: {}", describe(result));
    } else {
      spdlog::error("not as expected: {}", describe(result));
    }
  }
}

int tell_outcome(const RunRecord& record) {
  warn_of_caps(record);
  tell_expectations(record);
  if (!record.failure.empty()) {
    spdlog::error("the run failed: {}", record.failure);
    return exit_failed;
  }
  if (record.interrupted) {
    spdlog::warn("interrupted after step {} of {}", record.steps, record.steps_wanted);
    return exit_interrupted;
  }
  return record.met_expectations() ? exit_ok : exit_unexpected;
}

int tell_end(const RunRecord& record, const fs::path& folder, Telling telling) {
  const int code = tell_outcome(record);
  if (telling == Telling::json_lines) return code;
  spdlog::info("{} steps in {:.3g} s, {:.3g} steps/s; results in:", record.steps,
               record.wall_seconds, record.steps / record.wall_seconds);
  fmt::print("{}\n", folder.string());
  return code;
}

int run_in(const fs::path& folder, const std::string& name, const Scene& scene,
           Simulation& simulation, Telling telling) {
  try {
    return tell_end(SceneRun(scene, simulation, folder).run(name, telling), folder, telling);
  } catch (const Error& error) {
    spdlog::error("{}", error.what());
    return exit_failed;
  }
}

void tell_size(const std::string& name, const Simulation& simulation) {
  const Strands& strands = simulation.model().strands;
  spdlog::info("{}: {} strands, {} vertices, {} pinned", name, strands.count(),
               strands.vertex_count(), simulation.model().pins.size());
}

int begin(Registry& registry, const Arguments& arguments, Telling telling) {
  const std::string name = fs::path(*arguments.operand(0)).stem().string();
  const Scene scene = read_scene_argument(registry, arguments);
  Simulation simulation(scene);
  tell_size(name, simulation);
  return run_in(create_run_folder(arguments.value("--output"), name), name, scene, simulation,
                telling);
}

void refuse_what_resume_cannot_change(const Arguments& arguments) {
  for (const char* option : {"--set", "--output"}) {
    if (arguments.has(option)) {
      throw Error(
          fmt::format("'{}' cannot be given with --resume: the run goes on as its "
                      "scene.resolved.json says, in the same folder",
                      option));
    }
  }
}

/// Goes on from the last checkpoint, or, if there is none, begins once more.
int resume(Registry& registry, const Arguments& arguments, Telling telling) {
  refuse_what_resume_cannot_change(arguments);
  const fs::path folder = *arguments.value("--resume");
  const Scene scene = read_scene_of_run(folder, registry, arguments);
  const std::string name = name_of_run(folder);
  Simulation simulation(scene);
  tell_size(name, simulation);
  const auto checkpoint = read_checkpoint_file(folder);
  SceneRun run(scene, simulation, folder, checkpoint);
  spdlog::info("going on after step {} of {}", simulation.steps_done(), scene.run.steps);
  try {
    return tell_end(run.run(name, telling), folder, telling);
  } catch (const Error& error) {
    spdlog::error("{}", error.what());
    return exit_failed;
  }
}

Telling read_telling(const Arguments& arguments) {
  if (arguments.has("--quiet")) spdlog::set_level(spdlog::level::warn);
  if (arguments.has("--json-lines")) return Telling::json_lines;
  return arguments.has("--quiet") ? Telling::nothing : Telling::progress;
}

int run(Registry& registry, const Arguments& arguments) {
  const Telling telling = read_telling(arguments);
  if (arguments.has("--resume") == arguments.operand(0).has_value()) {
    throw Error("expected either SCENE.json or --resume DIR");
  }
  std::optional<tbb::global_control> threads;
  if (const auto count = arguments.integer("--threads", 1)) {
    threads.emplace(tbb::global_control::max_allowed_parallelism, *count);
  }
  return arguments.has("--resume") ? resume(registry, arguments, telling)
                                   : begin(registry, arguments, telling);
}

}  // namespace

Command run_command() {
  std::vector<Option> options{{.name = "--output",
                               .value = "DIR",
                               .meaning = "folder of the results, new or empty; results/SCENE if "
                                          "absent, or SCENE_2, ... if that exists",
                               .short_name = "-o"},
                              {.name = "--threads", .value = "N", .meaning = "all cores if absent"},
                              {.name = "--resume",
                               .value = "DIR",
                               .meaning = "instead of SCENE.json: goes on with an interrupted or "
                                          "killed run, to the same results as without a break"},
                              {.name = "--quiet", .meaning = "only warnings and errors"},
                              {.name = "--json-lines",
                               .meaning = "for programs: every step, and at last the summary, as a "
                                          "line of JSON on stdout"}};
  for (Option& option : scene_options()) options.push_back(std::move(option));
  return {"run",
          {"[SCENE.json]"},
          "simulates a scene, writes a folder of results and prints its name",
          options,
          run};
}

}  // namespace ringlet
