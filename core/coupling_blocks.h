#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/strand_bands.h"
#include "core/vertex_field.h"

namespace ringlet {

/// A symmetric matrix over arbitrary pairs of vertices, as contacts make it: collected block by
/// block, then split into what fits into the strand bands and what couples vertices beyond them.
class CouplingBlocks {
 public:
  CouplingBlocks() = default;
  explicit CouplingBlocks(const StrandGroups& groups)
      : groups_(&groups), group_blocks_(groups.count()), place_(groups.vertex_count()) {}

  void clear();
  /// Adds a term over up to four vertices, all different, the first two and the last two of them
  /// neighbours on a strand (two edges) where they have weight:
  ///
  ///     block(i, j) += w_i w_j C,   C symmetric and positive semi-definite
  ///
  /// What fits into the bands goes there, but never so that what remains of the term in the bands
  /// is indefinite: where two of the vertices are on one strand, but too far apart for its band,
  /// the edges count as two strands.
  void add(const std::array<int, 4>& vertices, const std::array<double, 4>& weights,
           const Eigen::Matrix3d& curvature);
  /// Sorts what was added; call once after the last add(). Blocks that couple a pinned vertex with
  /// another one are dropped: free is 1 for a free vertex and 0 for a pinned one.
  void finish(const VertexScalars& free);

  bool empty() const { return entries_.empty(); }
  /// Number of blocks outside the bands, counting both triangles.
  int off_band_count() const { return off_band_count_; }
  /// Whether blocks outside the bands touch strands of the group.
  bool touches(int group) const { return !group_blocks_[group].off_band.empty(); }
  /// Adds the blocks that belong there to the bands of a group.
  void add_to_bands(int group, GroupBands bands) const;
  /// y += C x for the rows of a group, C being all blocks outside the bands.
  void add_product(int group, const VertexField& x, VertexField& y) const;

  /// The vertices that have blocks outside the bands, one group after the other.
  int coupled_count() const { return coupled_count_; }
  /// Those of a group, in lane order, and the number of the first among all of them.
  std::span<const int> coupled(int group) const { return group_blocks_[group].coupled; }
  int first_coupled(int group) const { return group_blocks_[group].first_coupled; }
  /// y = C x for the coupled vertices of a group; x has an entry a coupled vertex of all groups.
  void multiply(int group, std::span<const Vector3<double>> x, std::span<Vector3<double>> y) const;

  /// Visits the blocks outside the bands, rows in lane order: visit(row_vertex, column_vertex,
  /// block).
  template <class Visit>
  void for_each_off_band(const Visit& visit) const {
    for (const GroupBlocks& group : group_blocks_) {
      for (const Block& block : group.off_band) visit(block.row, block.column, block.values);
    }
  }

 private:
  struct Entry {
    int i, j;
    bool in_band;
    Eigen::Matrix3d block;
  };
  /// An entry as a row outside the bands sees it.
  struct Reference {
    std::int64_t key;  ///< orders blocks by row and column in lane order
    int entry;
    bool transposed;
    bool operator<(const Reference& other) const {
      return key != other.key ? key < other.key : entry < other.entry;
    }
  };
  struct Block {
    int row, column;  ///< vertices
    Eigen::Matrix3d values;
  };
  struct GroupBlocks {
    std::vector<int> in_band;           ///< indices of entries
    std::vector<Reference> references;  ///< to entries with a row in this group outside the bands
    std::vector<Block> off_band;        ///< summed, sorted by row and column in lane order
    std::vector<int> coupled;           ///< the rows of these blocks
    int first_coupled = 0;
  };
  bool on_one_strand(int i, int j) const;
  bool fit_into_band(int i, int j) const;
  void refer(int row, int column, int entry, bool transposed);
  void sum_off_band(GroupBlocks& group) const;

  const StrandGroups* groups_ = nullptr;
  std::vector<Entry> entries_;
  std::vector<GroupBlocks> group_blocks_;
  std::vector<int> place_;  ///< among the coupled vertices, of each of these
  int off_band_count_ = 0, coupled_count_ = 0;
};

}  // namespace ringlet
