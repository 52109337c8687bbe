#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/suggest.h"

namespace ringlet {

/// Of things with names, the one that is wanted, or all. Throws Error if there is none of that
/// name; `what` is what they are.
template <class Named>
std::vector<Named> chosen(const std::vector<Named>& all, const std::optional<std::string>& wanted,
                          const std::string& what) {
  if (!wanted) return all;
  std::vector<std::string> names;
  for (const Named& one : all) {
    if (one.name == *wanted) return {one};
    names.push_back(one.name);
  }
  throw Error("there is no " + what + " '" + *wanted + "'; " + did_you_mean(*wanted, names));
}

}  // namespace ringlet
