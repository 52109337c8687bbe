#pragma once

#include "core/registry.h"

namespace ringlet {

/// The JSON Schema (draft 2020-12) of a scene that may name every plugin of the registry. What
/// several keys together or a file must fulfil is not in it: read_scene() alone decides.
Json scene_schema(const Registry& registry);

}  // namespace ringlet
