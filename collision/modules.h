#pragma once

#include "core/registry.h"

namespace ringlet {

/// Registers the collision stages and colliders of this folder.
void register_collision(Registry& registry);

}  // namespace ringlet
