#include "apps/help.h"

#include <spdlog/fmt/fmt.h>

namespace ringlet {
namespace {

std::string describe(const Option& option) {
  std::string spelling = option.name;
  if (!option.short_name.empty()) spelling = option.short_name + ", " + spelling;
  if (!option.value.empty()) spelling += " " + option.value;
  return fmt::format("      {:<22} {}\n", spelling, option.meaning);
}

std::string describe(const Command& command) {
  std::string text =
      fmt::format("  ringlet {} {}{}\n      {}\n", command.name, fmt::join(command.operands, " "),
                  command.options.empty() ? "" : " [options]", command.summary);
  for (const Option& option : command.options) text += describe(option);
  return text;
}

}  // namespace

std::string help_text(const std::vector<Command>& commands) {
  std::string text = "ringlet simulates strands.\n\n";
  for (const Command& command : commands) text += describe(command);
  return text +
         "  ringlet help | --help | --version\n"
         "\n"
         "Exit codes: 0 all is well; 1 the run ended but not as its scene expects; 2 bad input,\n"
         "nothing was written; 3 the run failed, its last good state is on disk; 130 interrupted\n"
         "by Ctrl-C or SIGTERM after a whole step, everything so far is on disk.\n";
}

}  // namespace ringlet
