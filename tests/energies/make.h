#pragma once

#include <memory>
#include <string>

#include "core/registry.h"
#include "core/verify/shapes.h"

namespace ringlet::test {

/// Plugins of the registry with the given JSON, {"type": NAME, ...}.
std::unique_ptr<Energy> make_energy(const Json& json);
std::unique_ptr<Force> make_force(const Json& json);

/// One strand with an energy bound to it.
BoundEnergy bound(const std::string& name, const Points& rest, const std::string& filter = "exact");

}  // namespace ringlet::test
