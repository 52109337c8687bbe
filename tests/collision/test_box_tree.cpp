#include <algorithm>
#include <limits>

#include "collision/box_tree.h"
#include "tests/catch.h"
#include "tests/collision/random_strands.h"

using namespace ringlet;

namespace {

std::vector<BoundingBox> random_boxes(std::mt19937& random, int count) {
  std::vector<BoundingBox> boxes;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d p = random_point(random, 1);
    boxes.emplace_back(p, p + random_point(random, 0.1).cwiseAbs());
  }
  return boxes;
}

using Pairs = std::vector<std::pair<int, int>>;

Pairs overlapping(const std::vector<BoundingBox>& boxes) {
  Pairs pairs;
  const int count = static_cast<int>(boxes.size());
  for (int i = 0; i < count; ++i) {
    for (int j = i + 1; j < count; ++j) {
      if (boxes[i].intersects(boxes[j])) pairs.emplace_back(i, j);
    }
  }
  return pairs;
}

Pairs found_by(const BoxTree& tree) {
  std::vector<BoxPair> found;
  for (int part = 0; part < tree.part_count(); ++part) tree.find_pairs(part, found);
  Pairs pairs;
  for (const auto& [first, second] : found) pairs.emplace_back(first, second);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace

TEST_CASE("a tree of boxes finds what overlaps, as brute force does, wherever the boxes go") {
  const int count = GENERATE(1, 2, 15, 16, 17, 33, 1000);
  CAPTURE(count);
  std::mt19937 random(61);
  std::vector<BoundingBox> boxes = random_boxes(random, count);
  BoxTree tree(boxes);
  for (int move = 0; move < 3; ++move) {
    CHECK(found_by(tree) == overlapping(boxes));
    const BoundingBox asked(Eigen::Vector3d(-0.2, -0.5, 0), Eigen::Vector3d(0.3, 0.1, 0.4));
    std::vector<int> expected, found;
    for (int i = 0; i < count; ++i) {
      if (boxes[i].intersects(asked)) expected.push_back(i);
    }
    tree.find_overlapping(asked, found);
    std::sort(found.begin(), found.end());
    CHECK(found == expected);
    boxes = random_boxes(random, count);
    tree.refit(boxes);
  }
}

TEST_CASE("boxes that touch overlap, far from where the tree looks too") {
  std::vector<BoundingBox> boxes;
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d low(1e6 + 0.1 * i, 1e6, -1e6), high(1e6 + 0.1 * (i + 1), 1e6, -1e6);
    boxes.emplace_back(low, high);
  }
  const Pairs found = found_by(BoxTree(boxes));
  const Pairs expected = overlapping(boxes);
  REQUIRE(expected.size() == 99);
  CHECK(std::includes(found.begin(), found.end(), expected.begin(), expected.end()));
}

TEST_CASE("an infinite box overlaps all others, a box that is no number none") {
  std::mt19937 random(67);
  std::vector<BoundingBox> boxes = random_boxes(random, 203);
  BoxTree tree(boxes);
  boxes[50].min().setConstant(-std::numeric_limits<double>::infinity());
  boxes[50].max().setConstant(1e300);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  boxes[7].min().x() = boxes[7].max().x() = nan;
  boxes[100] = BoundingBox(Eigen::Vector3d(nan, nan, nan), Eigen::Vector3d(nan, nan, nan));
  tree.refit(boxes);
  CHECK(found_by(tree) == overlapping(boxes));
}
