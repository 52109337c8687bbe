#pragma once

#include "core/registry.h"

namespace ringlet {

/// A plugin as a scene would choose it, {"type": NAME, ...} or NAME, outside of a scene. What is
/// wrong with it is appended to the problems.
template <class Interface>
Choice<Interface> read_choice(const Registry& registry, const Json& json,
                              std::vector<Problem>& problems) {
  ParseContext context{registry, ".", {}, problems};
  Choice<Interface> choice;
  Codec<Choice<Interface>>::read(json, "", {}, context, choice);
  return choice;
}

/// The plugin itself. Throws InvalidInput with everything that is wrong.
template <class Interface>
std::unique_ptr<Interface> make_chosen(const Registry& registry, const Json& json) {
  std::vector<Problem> problems;
  const Choice<Interface> choice = read_choice<Interface>(registry, json, problems);
  if (!problems.empty()) throw InvalidInput(std::move(problems));
  return choice.make();
}

}  // namespace ringlet
