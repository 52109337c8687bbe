#pragma once

#include "core/registry.h"

namespace ringlet {

/// Adds the force "end_moment": a moment about -z, N m, on the last edge of each strand, whose
/// potential is -M phi with the angle phi of that edge in the x, y plane. It is brought on over ten
/// steps, and phi is followed over the steps, so that it may exceed a turn. Springs hold the strand
/// in the plane, which it would leave from half a turn on.
void register_end_moment(Registry& registry);

}  // namespace ringlet
