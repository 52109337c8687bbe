// Writes a small complete project of a plugin: an example of plugins/ under another name.

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <map>

#include "apps/bundled_projects.h"
#include "apps/commands/command.h"
#include "apps/exit_codes.h"
#include "apps/run_folder.h"
#include "core/atomic_file.h"

namespace ringlet {
namespace {

/// What can be new, and the example from which it starts.
const std::map<std::string, std::string> examples{{"energy", "chord_bend"},
                                                  {"solver", "conjugate_residual"},
                                                  {"collider", "ring"},
                                                  {"writer", "tip_track"}};

std::vector<std::string> kinds() {
  std::vector<std::string> names;
  for (const auto& [kind, example] : examples) names.push_back(kind);
  return names;
}

bool is_name(const std::string& name) {
  const auto fits = [](unsigned char c) { return std::islower(c) || std::isdigit(c) || c == '_'; };
  return std::islower(static_cast<unsigned char>(name[0])) != 0 &&
         std::all_of(name.begin(), name.end(), fits);
}

void check_name(const Registry& registry, const std::string& name) {
  if (name.empty() || !is_name(name)) {
    throw Error("'" + name + "' is no name; expected lower-case letters, digits and underscores");
  }
  registry.for_each_kind([&](const std::string& kind, const auto& catalogue) {
    if (catalogue.find(name) == nullptr) return;
    throw Error("there is a plugin '" + name + "' (" + kind + ") already; choose another name");
  });
}

/// new_bend becomes NewBend.
std::string type_name(const std::string& name) {
  std::string type;
  bool starts_word = true;
  for (const char c : name) {
    if (c != '_') type += starts_word ? static_cast<char>(std::toupper(c)) : c;
    starts_word = c == '_';
  }
  return type;
}

bool is_word(const std::string& text, std::size_t at, std::size_t size) {
  const auto is = [&](auto kind, std::size_t place) {
    return place < text.size() && kind(static_cast<unsigned char>(text[place])) != 0;
  };
  return !(at > 0 && is(isalpha, at - 1)) && !is(islower, at + size);
}

/// Only where it is a word: 'ring' in 'register_ring' and not in 'string', 'Ring' in
/// 'RingParameters'.
std::string replace_all(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at)) {
    const bool replaces = is_word(text, at, from.size());
    if (replaces) text.replace(at, from.size(), to);
    at += replaces ? to.size() : from.size();
  }
  return text;
}

int write_project(const Registry& registry, const Arguments& arguments) {
  const std::string kind = *arguments.operand(0), name = *arguments.operand(1);
  const auto example = examples.find(kind);
  if (example == examples.end()) {
    throw Error("'" + kind + "' cannot be started from an example; " + did_you_mean(kind, kinds()));
  }
  check_name(registry, name);
  const auto folder = create_empty_folder(arguments.operand(2).value_or(name));
  const auto renamed = [&](const std::string& text) {
    return replace_all(replace_all(text, example->second, name), type_name(example->second),
                       type_name(name));
  };
  for (const auto& [file_name, text] : bundled_project(example->second)) {
    AtomicFile file(folder / renamed(file_name));
    file.stream() << renamed(text);
    file.commit();
  }
  fmt::print("{}: see README.md there\n", folder.string());
  return exit_ok;
}

}  // namespace

Command new_command() {
  return {"new",
          {"KIND", "NAME", "[DIR]"},
          fmt::format("writes a small complete project of a plugin, for a start; KIND: {}",
                      fmt::join(kinds(), ", ")),
          {},
          write_project};
}

}  // namespace ringlet
