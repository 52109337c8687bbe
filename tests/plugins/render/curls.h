#pragma once

#include <cmath>

#include "plugins/render/strand_shapes.h"

namespace ringlet {

/// Upright helices beside each other, thinner to the tip.
inline StrandShapes curls(int count, int vertices) {
  StrandShapes strands;
  strands.positions.resize(3, count * vertices);
  for (int strand = 0; strand < count; ++strand) {
    strands.vertex_counts.push_back(vertices);
    for (int i = 0; i < vertices; ++i) {
      const double angle = 1.2 * i + strand;
      strands.positions.col(strand * vertices + i) << 0.03 * strand + 0.005 * std::cos(angle),
          0.001 * i, 0.005 * std::sin(angle);
      strands.radii.push_back(0.003 - 0.002 * i / vertices);
    }
  }
  return strands;
}

}  // namespace ringlet
