#pragma once

#include "core/model.h"
#include "core/parallel.h"

namespace ringlet {

/// sum over all vertices of m |v|^2 / 2, J.
inline double kinetic_energy(const Model& model, const VertexField& velocities) {
  return parallel_sum(model.groups.count(), [&](int g) {
    const auto rows = velocities.group(g);
    const Pack* mass = &model.mass[model.groups[g].first_row];
    Pack energy = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) energy += 0.5 * mass[i] * squared_norm(rows[i]);
    return sum_lanes(energy);
  });
}

}  // namespace ringlet
