#pragma once

#include <string>

#include "core/parameters.h"

namespace ringlet {

/// The entry of a scene at a JSON pointer becomes the value. Objects on the way are made where they
/// are missing. Throws Error if the pointer is none or leads through what is no object or list.
void set_entry(Json& scene, const std::string& pointer, const Json& value);

/// Changes a scene as `--set POINTER=VALUE` asks: the entry at the JSON pointer becomes the value,
/// which is JSON or, if it is not, text. Throws Error as set_entry() does.
void apply_override(Json& scene, const std::string& assignment);

}  // namespace ringlet
