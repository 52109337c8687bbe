#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>
#include <tbb/global_control.h>

#include "apps/commands/command.h"
#include "apps/commands/scene_argument.h"
#include "apps/exit_codes.h"
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

int run_in(const fs::path& folder, const std::string& name, const Scene& scene,
           Simulation& simulation, bool quiet) {
  try {
    const RunRecord record = SceneRun(scene, simulation, folder).run(name, quiet);
    const int code = tell_outcome(record);
    spdlog::info("{} steps in {:.3g} s, {:.3g} steps/s; results in:", record.steps,
                 record.wall_seconds, record.steps / record.wall_seconds);
    fmt::print("{}\n", folder.string());
    return code;
  } catch (const Error& error) {
    spdlog::error("{}", error.what());
    return exit_failed;
  }
}

int run(Registry& registry, const Arguments& arguments) {
  const std::string name = fs::path(*arguments.operand(0)).stem().string();
  const bool quiet = arguments.has("--quiet");
  if (quiet) spdlog::set_level(spdlog::level::warn);
  std::optional<tbb::global_control> threads;
  if (const auto count = arguments.integer("--threads", 1)) {
    threads.emplace(tbb::global_control::max_allowed_parallelism, *count);
  }
  const Scene scene = read_scene_argument(registry, arguments);
  Simulation simulation(scene);
  const Strands& strands = simulation.model().strands;
  spdlog::info("{}: {} strands, {} vertices, {} pinned", name, strands.count(),
               strands.vertex_count(), simulation.model().pins.size());
  return run_in(create_run_folder(arguments.value("--output"), name), name, scene, simulation,
                quiet);
}

}  // namespace

Command run_command() {
  std::vector<Option> options{{.name = "--output",
                               .value = "DIR",
                               .meaning = "folder of the results, new or empty; results/SCENE if "
                                          "absent, or SCENE_2, ... if that exists",
                               .short_name = "-o"},
                              {.name = "--threads", .value = "N", .meaning = "all cores if absent"},
                              {.name = "--quiet", .meaning = "only warnings and errors"}};
  for (Option& option : scene_options()) options.push_back(std::move(option));
  return {"run",
          {"SCENE.json"},
          "simulates a scene, writes a folder of results and prints its name",
          options,
          run};
}

}  // namespace ringlet
