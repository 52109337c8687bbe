#pragma once

#include <optional>
#include <string>

#include "core/model.h"

namespace ringlet {

/// Says in words which vertex an energy holds most stiffly in comparison with its inertia over a
/// step of length dt, s, and how much more; nothing where no energy resists. Slow; for error
/// messages.
std::optional<std::string> describe_stiffest_vertex(const Model& model, const VertexField& x,
                                                    double dt);

}  // namespace ringlet
