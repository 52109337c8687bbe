#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/material_field.h"

namespace ringlet {

/// What a strand source makes: polylines in their rest shape, and how each is held.
struct StrandSet {
  std::vector<int> vertex_counts;          ///< vertices of each strand, root first, >= 2
  std::vector<Eigen::Vector3d> positions;  ///< all vertices, strand after strand, m
  std::vector<int> pinned_counts;          ///< of each strand: pinned vertices from the root
  std::vector<std::string> motions;        ///< of each strand: motion of its pins, "" = none
};

/// The strands of a scene: topology, rest shape, radii and masses. Immutable. Vertices are numbered
/// strand after strand from root to tip; edge v joins the vertices v and v + 1 of one strand.
class Strands {
 public:
  /// pinned_counts: of each strand, how many vertices from the root are pinned; empty: none is.
  /// Throws Error if a strand has fewer than two vertices, a position is not finite, or the
  /// material has not one number for each strand or vertex where it should.
  Strands(std::vector<int> vertex_counts, std::vector<Eigen::Vector3d> rest_positions,
          const MaterialField& material, std::vector<int> pinned_counts = {});

  int count() const { return static_cast<int>(first_.size()) - 1; }
  int vertex_count() const { return first_.back(); }
  int edge_count() const { return vertex_count() - count(); }
  /// The first vertex of a strand; first(count()) is vertex_count().
  int first(int strand) const { return first_[strand]; }
  int size(int strand) const { return first_[strand + 1] - first_[strand]; }
  /// Whether both ends of the edge from this vertex to the next are pinned by its strand: it stays
  /// as it is, and no part of the strand bends in it.
  bool is_held_edge(int vertex) const {
    const int strand = strand_of(vertex);
    return !pinned_counts_.empty() && vertex - first(strand) + 1 < pinned_counts_[strand];
  }
  int strand_of(int vertex) const { return strand_of_[vertex]; }

  const MaterialField& material() const { return material_; }
  const Eigen::Vector3d& rest_position(int vertex) const { return rest_positions_[vertex]; }
  /// Rest length of the edge from this vertex to the next on its strand, m; 0 at a tip.
  double rest_length(int vertex) const { return rest_lengths_[vertex]; }
  /// Half of the rest lengths of the edges that meet at a vertex, m.
  double voronoi_length(int vertex) const;
  double radius(int vertex) const { return radii_[vertex]; }  ///< m
  double mass(int vertex) const { return masses_[vertex]; }   ///< lumped, kg
  /// Rest length of a whole strand, m.
  double strand_length(int strand) const { return root_distances_[first_[strand + 1] - 1]; }
  /// How far a vertex is from the root of its strand at rest: 0 at the root, 1 at the tip.
  double fraction_along(int vertex) const;
  /// The memory that they hold.
  std::size_t bytes() const;

 private:
  void measure_lengths();
  void measure_cross_sections();

  MaterialField material_;
  std::vector<int> first_;
  std::vector<int> strand_of_;
  std::vector<int> pinned_counts_;
  std::vector<Eigen::Vector3d> rest_positions_;
  std::vector<double> rest_lengths_;
  std::vector<double> root_distances_;  ///< along the strand
  std::vector<double> radii_;
  std::vector<double> masses_;
};

}  // namespace ringlet
