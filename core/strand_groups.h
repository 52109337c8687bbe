#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/huge_pages.h"
#include "core/lanes.h"
#include "core/strands.h"

namespace ringlet {

/// Strands side by side, one a lane.
struct StrandGroup {
  int first_row;                        ///< row of their root vertices
  int vertices;                         ///< of the longest of them: the rows of the group
  std::array<int, lane_count> strands;  ///< -1: a pad lane
};

/// Some rows of a group, counted from its first one.
struct RowRange {
  int first, end;

  int count() const { return end - first; }
};

/// Where a vertex lives in lane order.
struct LaneSlot {
  int row;
  int lane;
};

/// The order in which strands are computed: groups of lane_count, longest strands first so that the
/// members of a group are about equally long; those that are held come last, in groups of their
/// own, which need not be solved. A row holds one vertex of each of them. Lanes without a strand
/// and rows behind the tip of a shorter strand are pads: they carry a benign geometry, no
/// stiffness, and a multiple of the identity in the system matrix.
class StrandGroups {
 public:
  /// is_held: of each strand, whether all of its vertices are pinned; empty: none is.
  explicit StrandGroups(const Strands& strands, const std::vector<bool>& is_held = {});

  int count() const { return static_cast<int>(groups_.size()); }
  int rows() const { return rows_; }
  const StrandGroup& operator[](int group) const { return groups_[group]; }
  LaneSlot slot(int vertex) const { return slots_[vertex]; }
  int vertex_count() const { return static_cast<int>(slots_.size()); }
  int group_of(int vertex) const { return group_of_row_[slots_[vertex].row]; }
  /// The vertex at a place of a group, or -1 for a pad.
  int vertex_at(int row, int lane) const { return vertex_at_[row * lane_count + lane]; }

  std::size_t bytes() const;

 private:
  /// Of strands, the longest first.
  void add_groups(const Strands& strands, std::span<const int> order);

  std::vector<StrandGroup> groups_;
  StreamedVector<LaneSlot> slots_;
  std::vector<int> group_of_row_;
  StreamedVector<int> vertex_at_;
  int rows_ = 0;
};

}  // namespace ringlet
