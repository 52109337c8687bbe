#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cstdio>
#include <sstream>

#include "apps/commands/command.h"
#include "apps/exit_codes.h"

namespace ringlet {
namespace {

// "linear solver" is meant by its name, by linear-solver, and by either of its words.
bool is_meant(const std::string& kind, std::string wanted) {
  std::replace(wanted.begin(), wanted.end(), '-', ' ');
  if (kind == wanted) return true;
  std::istringstream words(kind);
  for (std::string word; words >> word;) {
    if (word == wanted) return true;
  }
  return false;
}

int list(const Registry& registry, const Arguments& arguments) {
  const auto wanted = arguments.operand(0);
  std::vector<std::string> kinds;
  bool found = false;
  registry.for_each_kind([&](const std::string& kind, const auto& catalogue) {
    kinds.push_back(kind);
    if (wanted && !is_meant(kind, *wanted)) return;
    found = true;
    fmt::print("{}\n", kind);
    for (const auto& entry : catalogue.entries()) {
      fmt::print("  {:<18} {}{}\n", entry.name, entry.description.text,
                 entry.library.empty() ? "" : " [" + entry.library + "]");
    }
  });
  if (!found) throw Error("there is no kind '" + *wanted + "'; " + did_you_mean(*wanted, kinds));
  return exit_ok;
}

}  // namespace

Command list_command() {
  return {"list", {"[KIND]"}, "what a scene can name: energies, solvers, colliders, ...", {}, list};
}

}  // namespace ringlet
