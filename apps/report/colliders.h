#pragma once

#include <string>
#include <vector>

#include "core/registry.h"

namespace ringlet {

/// The colliders of a resolved scene as the page shows them: their shape, and their poses (x, y, z
/// and a quaternion x, y, z, w) at some times. Of what cannot be shown, a note says so.
Json describe_colliders(const Json& scene, const Registry& registry,
                        const std::vector<double>& times, std::vector<std::string>& notes);

}  // namespace ringlet
