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

/// Finds overlaps of axis-aligned boxes with FCL's dynamic AABB tree. Boxes that touch overlap.
class BoxTree {
 public:
  explicit BoxTree(std::span<const BoundingBox> boxes);
  ~BoxTree();
  BoxTree(const BoxTree&) = delete;
  BoxTree& operator=(const BoxTree&) = delete;

  /// The boxes, as many as before, have moved: the tree is refitted, not built anew.
  void refit(std::span<const BoundingBox> boxes);
  /// All overlapping pairs, sorted by first, then second.
  std::vector<BoxPair> overlapping_pairs() const;
  /// Appends the boxes that overlap a given one, in no particular order. Thread-safe.
  void find_overlapping(const BoundingBox& box, std::vector<int>& found) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace ringlet
