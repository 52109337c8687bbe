#include <spdlog/fmt/fmt.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cstdio>

#include "apps/build_info.h"
#include "apps/exit_codes.h"
#include "apps/help.h"
#include "collision/modules.h"
#include "core/load_plugin.h"
#include "core/modules.h"
#include "energies/modules.h"
#include "plugins/modules.h"
#include "solvers/modules.h"

namespace ringlet {
namespace {

/// What every command that looks at plugins takes.
const Option plugin_option{.name = "--plugin",
                           .value = "FILE",
                           .meaning = "loads a plugin library; may be repeated",
                           .repeatable = true};

int dispatch(Registry& registry, const std::vector<std::string>& words) {
  std::vector<Command> commands{
      run_command(),      study_command(), report_command(),   render_command(), convert_command(),
      check_command(),    list_command(),  describe_command(), new_command(),    verify_command(),
      validate_command(), eval_command(),  bench_command()};
  for (Command& command : commands) command.options.push_back(plugin_option);
  const std::string name = words.empty() ? "help" : words.front();
  const bool wants_help = name == "help" || name == "--help" || name == "-h" ||
                          std::find(words.begin(), words.end(), "--help") != words.end();
  if (wants_help) {
    fmt::print("{}", help_text(commands));
    return words.empty() ? exit_bad_input : exit_ok;
  }
  if (name == "--version") {
    fmt::print("ringlet {}\n", build_info::version);
    return exit_ok;
  }
  std::vector<std::string> known{"help"};
  for (const Command& command : commands) {
    known.push_back(command.name);
    if (command.name != name) continue;
    const Arguments arguments({words.begin() + 1, words.end()}, command.operands, command.options);
    for (const std::string& plugin : arguments.values(plugin_option.name)) {
      load_plugin(plugin, ".", registry);
    }
    return command.run(registry, arguments);
  }
  throw Error("unknown command '" + name + "'; " + did_you_mean(name, known));
}

int run_program(const std::vector<std::string>& words) {
  spdlog::set_default_logger(spdlog::stderr_color_mt("ringlet"));
  spdlog::set_pattern("%H:%M:%S %^%l%$: %v");
  Registry registry;
  register_core(registry);
  register_energies(registry);
  register_solvers(registry);
  register_collision(registry);
  register_plugins(registry);
  try {
    return dispatch(registry, words);
  } catch (const Error& error) {
    spdlog::error("{}", error.what());
    return exit_bad_input;
  } catch (const std::bad_alloc&) {
    spdlog::error("there is not enough memory");
    return exit_failed;
  } catch (const std::exception& error) {
    spdlog::error("unexpected, perhaps of a plugin: {}", error.what());
    return exit_failed;
  }
}

}  // namespace
}  // namespace ringlet

int main(int argc, char** argv) { return ringlet::run_program({argv + 1, argv + argc}); }
