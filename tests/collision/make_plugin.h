#pragma once

#include <memory>
#include <string>

#include "collision/modules.h"

namespace ringlet {

/// A plugin of the collision library from its JSON, as a scene would make it. Throws InvalidInput.
template <class Interface>
std::unique_ptr<Interface> make_plugin(const Json& json) {
  Registry registry;
  register_collision(registry);
  std::vector<Problem> problems;
  ParseContext context{registry, "/", {"nod"}, problems};
  Choice<Interface> choice;
  Codec<Choice<Interface>>::read(json, "/plugin", {}, context, choice);
  if (!problems.empty()) throw InvalidInput(problems);
  return choice.make();
}

}  // namespace ringlet
