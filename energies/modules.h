#pragma once

#include "core/registry.h"

namespace ringlet {

/// Registers the energies and forces of this folder.
void register_energies(Registry& registry);

}  // namespace ringlet
