#pragma once

#include <functional>
#include <numbers>

#include "apps/validate/validation.h"
#include "core/simulation.h"

namespace ringlet {

inline constexpr double pi = std::numbers::pi;

/// The simulation of a scene after its steps. Throws Error if one fails, or, where the last one
/// must be an equilibrium, if Newton's method did not converge.
std::unique_ptr<Simulation> run_scene(const Json& scene, const Registry& registry);

/// Gives a straight strand a free part of so many edges, of this length, m, after a clamp that is
/// one more edge.
void set_clamped_edges(Json& scene, int edges, double length);

/// p where an error falls as (1 / n)^p, from the errors at n and 2n.
double observed_order(double coarse_error, double fine_error);

}  // namespace ringlet
