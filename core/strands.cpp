#include "core/strands.h"

#include <numeric>

#include "core/error.h"

namespace ringlet {

Strands::Strands(std::vector<int> vertex_counts, std::vector<Eigen::Vector3d> rest_positions,
                 const Material& material)
    : material_(material), rest_positions_(std::move(rest_positions)) {
  first_.assign(1, 0);
  for (int strand = 0; const int vertices : vertex_counts) {
    if (vertices < 2) {
      throw Error("strand " + std::to_string(strand) + " has " + std::to_string(vertices) +
                  " vertices; a strand needs at least 2");
    }
    first_.push_back(first_.back() + vertices);
    strand_of_.insert(strand_of_.end(), vertices, strand++);
  }
  if (vertex_count() != static_cast<int>(rest_positions_.size())) {
    throw Error("the strands count " + std::to_string(vertex_count()) + " vertices, but " +
                std::to_string(rest_positions_.size()) + " positions were given");
  }
  for (int vertex = 0; vertex < vertex_count(); ++vertex) {
    if (rest_positions_[vertex].allFinite()) continue;
    throw Error("strand " + std::to_string(strand_of(vertex)) + ", vertex " +
                std::to_string(vertex - first(strand_of(vertex))) + ": position is not finite");
  }
  measure_lengths();
  taper_radii();
  lump_masses();
}

void Strands::measure_lengths() {
  rest_lengths_.assign(vertex_count(), 0.0);
  for (int strand = 0; strand < count(); ++strand) {
    for (int v = first(strand); v + 1 < first(strand + 1); ++v) {
      rest_lengths_[v] = (rest_positions_[v + 1] - rest_positions_[v]).norm();
    }
  }
}

void Strands::taper_radii() {
  radii_.resize(vertex_count());
  const double root = material_.radius, tip = material_.tip_radius.value_or(root);
  for (int strand = 0; strand < count(); ++strand) {
    const double length = strand_length(strand);
    double travelled = 0;
    for (int v = first(strand); v < first(strand + 1); ++v) {
      radii_[v] = length > 0 ? root + (tip - root) * (travelled / length) : root;
      travelled += rest_lengths_[v];
    }
  }
}

void Strands::lump_masses() {
  masses_.resize(vertex_count());
  for (int v = 0; v < vertex_count(); ++v) {
    masses_[v] = material_.density * circle_area(radii_[v]) * voronoi_length(v);
  }
}

double Strands::voronoi_length(int vertex) const {
  const bool is_root = vertex == first(strand_of(vertex));
  return 0.5 * (rest_lengths_[vertex] + (is_root ? 0.0 : rest_lengths_[vertex - 1]));
}

double Strands::strand_length(int strand) const {
  return std::accumulate(rest_lengths_.begin() + first(strand),
                         rest_lengths_.begin() + first(strand + 1), 0.0);
}

}  // namespace ringlet
