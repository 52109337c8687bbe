#pragma once

#include "core/model.h"

namespace ringlet {

/// Writes a first guess of the positions x at the end of a step: x_n, those at its beginning,
/// except that a strand with pins moves rigidly with the motion of its first pin. All pins are then
/// where they belong, and the elastic energy is what it was. Leaving the strand behind instead
/// tears and folds it at the pins as soon as they move by about an edge a step: Newton's method
/// then takes ten times as many iterations, or ends in a minimum where the strand stays folded.
void carry_strands_with_pins(const Model& model, const VertexField& x_n, double time,
                             double time_end, VertexField& x);

}  // namespace ringlet
