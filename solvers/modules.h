#pragma once

#include "core/registry.h"

namespace ringlet {

/// Registers the linear solvers and integrators of this folder.
void register_solvers(Registry& registry);

}  // namespace ringlet
