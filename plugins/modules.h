#pragma once

namespace ringlet {

class Registry;

/// Registers the plugins of this folder: writers.
void register_plugins(Registry& registry);

}  // namespace ringlet
