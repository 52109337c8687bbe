// What the rest state `sag_free` holds does not move.

#include <algorithm>

#include "apps/validate/statics.h"

namespace ringlet {

void validate_sag_free(const Registry& registry, const ValidationOptions&,
                       const ValidationOutput& output) {
  const auto simulation = run_scene(validation_scene("sag_free"), registry);
  const Strands& strands = simulation->model().strands;
  double way = 0;
  for (int v = 0; v < strands.vertex_count(); ++v) {
    way = std::max(way, (simulation->state().positions.get(v) - strands.rest_position(v)).norm());
  }
  output({"sag_free", "acceleration at first / g", 0,
          simulation->model().rest.value().acceleration / 9.81, 1e-6});
  output({"sag_free", "way in 100 frames / length", 0, way / strands.strand_length(0), 1e-6});
}

}  // namespace ringlet
