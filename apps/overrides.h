#pragma once

#include <string>

#include "core/parameters.h"

namespace ringlet {

/// Changes a scene as `--set POINTER=VALUE` asks: the entry at the JSON pointer becomes the value,
/// which is JSON or, if it is not, text. Objects on the way are made where they are missing. Throws
/// Error if the pointer is none or leads through what is no object or list.
void apply_override(Json& scene, const std::string& assignment);

}  // namespace ringlet
