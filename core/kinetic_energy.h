#pragma once

#include "core/model.h"
#include "core/parallel.h"

namespace ringlet {

/// sum over the vertices of a group of m |v|^2 / 2, J.
inline double kinetic_energy(const Model& model, const VertexField& velocities, int group) {
  const auto rows = velocities.group(group);
  const Pack* mass = &model.mass[model.groups[group].first_row];
  Pack energy = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) energy += 0.5 * mass[i] * squared_norm(rows[i]);
  return sum_lanes(energy);
}

/// The same of all vertices.
inline double kinetic_energy(const Model& model, const VertexField& velocities) {
  return parallel_sum(model.groups.count(),
                      [&](int g) { return kinetic_energy(model, velocities, g); });
}

}  // namespace ringlet
