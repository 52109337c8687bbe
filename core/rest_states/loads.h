#pragma once

#include <string>
#include <vector>

#include "core/model.h"

namespace ringlet {

/// At x, where the strands stand still, the gradient of the potential of the named forces and of
/// the energies that cannot choose their rest state. Throws Error if the model has no such force.
VertexField gradient_of_loads(Model& model, const VertexField& x,
                              const std::vector<std::string>& forces);

/// Adds that of the energies that can choose their rest state, of the strands of a group.
void add_gradient_of_holding_energies(Model& model, int group, const VertexField& x,
                                      VertexField& gradient);

/// Of each strand, the largest acceleration |gradient| / mass of a free vertex, m/s^2.
std::vector<double> largest_accelerations(const Model& model, const VertexField& gradient);

}  // namespace ringlet
