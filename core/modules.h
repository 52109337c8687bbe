#pragma once

namespace ringlet {

class Registry;

/// Registers the plugins that core itself brings: strand sources and readers, roots, poses,
/// rest states, motions.
void register_core(Registry&);

}  // namespace ringlet
