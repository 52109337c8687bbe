#pragma once

#include "core/modules.h"
#include "core/registry.h"

namespace ringlet {

/// A plugin of core as a scene would choose it, and what is wrong with the choice.
template <class Interface>
struct ReadPlugin {
  Choice<Interface> choice;
  std::vector<Problem> problems;

  /// Whether there is exactly one problem, at this pointer, whose message contains a text.
  bool has_one_problem(const std::string& pointer, const std::string& text) const {
    return problems.size() == 1 && problems[0].pointer == pointer &&
           problems[0].message.find(text) != std::string::npos;
  }
};

template <class Interface>
ReadPlugin<Interface> read_plugin(const Json& json) {
  Registry registry;
  register_core(registry);
  ReadPlugin<Interface> result;
  ParseContext context{registry, std::filesystem::current_path(), {"nod"}, result.problems};
  Codec<Choice<Interface>>::read(json, "", {}, context, result.choice);
  return result;
}

/// The plugin of a choice without problems. Throws InvalidInput if it has any.
template <class Interface>
std::unique_ptr<Interface> make_plugin(const Json& json) {
  auto [choice, problems] = read_plugin<Interface>(json);
  if (!problems.empty()) throw InvalidInput(problems);
  return choice.make();
}

}  // namespace ringlet
