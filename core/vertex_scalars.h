#pragma once

#include "core/vertex_field.h"

namespace ringlet {

/// value(vertex) of every vertex in lane order.
template <class Value>
VertexScalars vertex_scalars(const StrandGroups& groups, const Value& value, double on_pads = 0) {
  VertexScalars scalars(groups.rows(), Pack(on_pads));
  for (int vertex = 0; vertex < groups.vertex_count(); ++vertex) {
    const auto [row, lane] = groups.slot(vertex);
    scalars[row][lane] = value(vertex);
  }
  return scalars;
}

}  // namespace ringlet
