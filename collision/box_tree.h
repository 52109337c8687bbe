#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <span>
#include <vector>

namespace ringlet {

using BoundingBox = Eigen::AlignedBox3d;

/// Two boxes that overlap; first < second.
struct BoxPair {
  int first, second;
};

/// Finds overlaps of axis-aligned boxes with FCL's dynamic AABB tree over bundles of neighbouring
/// ones, which are then tested side by side in lanes. Boxes that touch overlap, and so may ones
/// that come as near as rounding to floats, seen from one of the boxes.
class BoxTree {
 public:
  /// Boxes of finite size.
  explicit BoxTree(std::span<const BoundingBox> boxes);
  ~BoxTree();
  BoxTree(BoxTree&&) noexcept;
  BoxTree& operator=(BoxTree&&) noexcept;

  /// The boxes, as many as before, have moved: the tree is refitted, not built anew.
  void refit(std::span<const BoundingBox> boxes);

  /// The search for all overlapping pairs comes in parts, which threads can share. Each pair is
  /// found in exactly one of them.
  int part_count() const;
  /// Appends the pairs of one part, in no particular order. Thread-safe.
  void find_pairs(int part, std::vector<BoxPair>& pairs) const;

  /// Appends the boxes that overlap a given one, in no particular order. Thread-safe.
  void find_overlapping(const BoundingBox& box, std::vector<int>& found) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace ringlet
