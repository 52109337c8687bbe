#include "core/strands.h"

#include "core/bytes.h"
#include "core/error.h"

namespace ringlet {

Strands::Strands(std::vector<int> vertex_counts, std::vector<Eigen::Vector3d> rest_positions,
                 const MaterialField& material, std::vector<int> pinned_counts)
    : material_(material),
      pinned_counts_(std::move(pinned_counts)),
      rest_positions_(std::move(rest_positions)) {
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
  measure_cross_sections();
}

void Strands::measure_lengths() {
  rest_lengths_.assign(vertex_count(), 0.0);
  root_distances_.assign(vertex_count(), 0.0);
  for (int strand = 0; strand < count(); ++strand) {
    for (int v = first(strand); v + 1 < first(strand + 1); ++v) {
      rest_lengths_[v] = (rest_positions_[v + 1] - rest_positions_[v]).norm();
      root_distances_[v + 1] = root_distances_[v] + rest_lengths_[v];
    }
  }
}

void Strands::measure_cross_sections() {
  radii_.resize(vertex_count());
  masses_.resize(vertex_count());
  for (int v = 0; v < vertex_count(); ++v) {
    radii_[v] = material_.radius_at(*this, v);
    masses_[v] = material_.density.at(*this, v) * circle_area(radii_[v]) * voronoi_length(v);
  }
}

double Strands::fraction_along(int vertex) const {
  const double length = strand_length(strand_of(vertex));
  return length > 0 ? root_distances_[vertex] / length : 0;
}

double Strands::voronoi_length(int vertex) const {
  const bool is_root = vertex == first(strand_of(vertex));
  return 0.5 * (rest_lengths_[vertex] + (is_root ? 0.0 : rest_lengths_[vertex - 1]));
}

std::size_t Strands::bytes() const {
  return bytes_of(first_) + bytes_of(strand_of_) + bytes_of(pinned_counts_) +
         bytes_of(rest_positions_) + bytes_of(rest_lengths_) + bytes_of(root_distances_) +
         bytes_of(radii_) + bytes_of(masses_);
}

}  // namespace ringlet
