#include "core/stiffest_vertex.h"

#include <sstream>
#include <vector>

#include "core/strand_bands.h"

namespace ringlet {
namespace {

struct Stiffest {
  double ratio = 0;
  int vertex = -1;
  std::string energy;
};

void look_at_group(const Model& model, const Energy& energy, int group, const VertexField& x,
                   double dt, Stiffest& stiffest) {
  const auto [first_row, vertices, strands] = model.groups[group];
  std::vector<Matrix3<Pack>> blocks(vertices * band_blocks, Matrix3<Pack>::zero());
  const GroupBands hessian{std::span(blocks)};
  add_at_vertices(energy, group, x.group(group), {{}, hessian});
  for (int row = 0; row < vertices; ++row) {
    const Matrix3<Pack>& block = hessian.block(row, 0);
    for (int lane = 0; lane < lane_count; ++lane) {
      const int vertex = model.groups.vertex_at(first_row + row, lane);
      if (vertex < 0 || model.free[first_row + row][lane] == 0) continue;
      const double stiffness = (block(0, 0) + block(1, 1) + block(2, 2))[lane];
      const double ratio = stiffness * dt * dt / model.strands.mass(vertex);
      if (ratio > stiffest.ratio) stiffest = {ratio, vertex, energy.name()};
    }
  }
}

}  // namespace

std::optional<std::string> describe_stiffest_vertex(const Model& model, const VertexField& x,
                                                    double dt) {
  Stiffest stiffest;
  for (const auto& energy : model.energies) {
    for (int g = 0; g < model.groups.count(); ++g) {
      look_at_group(model, *energy, g, x, dt, stiffest);
    }
  }
  if (stiffest.vertex < 0) return std::nullopt;
  const int strand = model.strands.strand_of(stiffest.vertex);
  std::ostringstream text;
  text.precision(2);
  text << "'" << stiffest.energy << "' holds strand " << strand << ", vertex "
       << stiffest.vertex - model.strands.first(strand) << " " << stiffest.ratio
       << " times as stiffly as its inertia does in a step (double precision tells 1e15 apart)";
  return text.str();
}

}  // namespace ringlet
