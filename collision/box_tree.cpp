#include "collision/box_tree.h"

#include <fcl/broadphase/detail/hierarchy_tree.h>
#include <fcl/math/bv/AABB.h>

#include <cstdint>

#include "collision/box_lanes.h"
#include "collision/median_split.h"
#include "core/parallel.h"

namespace ringlet {
namespace {

// The tree itself, of which FCL's public broad phase managers are made. These add a collision
// object a box and a hash table to find its leaf, put every object that moved into the tree anew,
// and search with one thread and a callback a pair.
using Hierarchy = fcl::detail::HierarchyTree<fcl::AABBd>;
using Node = Hierarchy::NodeType;

// Enough parts that threads end at about the same time.
constexpr std::size_t query_parts = 512;

int index_of(const Node* leaf) {
  return static_cast<int>(reinterpret_cast<std::intptr_t>(leaf->data));
}

// FCL's own is no inline function.
bool overlap(const fcl::AABBd& a, const fcl::AABBd& b) {
  return a.min_.x() <= b.max_.x() && b.min_.x() <= a.max_.x() && a.min_.y() <= b.max_.y() &&
         b.min_.y() <= a.max_.y() && a.min_.z() <= b.max_.z() && b.min_.z() <= a.max_.z();
}

fcl::AABBd to_fcl(const BoundingBox& box) { return fcl::AABBd(box.min(), box.max()); }

void unite_children(Node* node) { node->bv = node->children[0]->bv + node->children[1]->bv; }

void refit_branches(Node* node) {
  if (node->isLeaf()) return;
  refit_branches(node->children[0]);
  refit_branches(node->children[1]);
  unite_children(node);
}

// False for what is not a number, which would spread to all boxes around it.
bool has_inside(const BoundingBox& box) { return (box.min().array() <= box.max().array()).all(); }

/// Some neighbouring boxes, which are tested side by side in lanes: the leaves of the tree.
struct Bundle {
  std::array<int, BoxLanes::size> boxes;
  BoxLanes lanes;
  BoxSides around;

  explicit Bundle(std::span<const int> part) {
    boxes.fill(-1);
    std::copy(part.begin(), part.end(), boxes.begin());
  }
  void refit(std::span<const BoundingBox> all, const Eigen::Vector3d& origin, Node* leaf) {
    BoundingBox sum;
    for (int lane = 0; lane < BoxLanes::size; ++lane) {
      const int box = boxes[lane];
      lanes.set(lane, box < 0 ? BoxSides::none() : BoxSides::around(all[box], origin));
      if (box >= 0 && has_inside(all[box])) sum.extend(all[box]);
    }
    around = BoxSides::around(sum, origin);
    leaf->bv = to_fcl(sum);
  }
};

/// Overlaps of the leaves of one subtree with those of another; or among each other, if the two
/// are the same.
struct Query {
  const Node *a, *b;
};

// Splits a query into ones of smaller subtrees.
template <class Visit>
void split(const Query& query, const Visit& visit) {
  const auto [a, b] = query;
  if (a == b) {
    visit(Query{a->children[0], a->children[0]});
    visit(Query{a->children[1], a->children[1]});
    visit(Query{a->children[0], a->children[1]});
  } else if (b->isLeaf() || (!a->isLeaf() && a->bv.size() > b->bv.size())) {
    for (const Node* child : a->children) visit(Query{child, b});
  } else {
    for (const Node* child : b->children) visit(Query{a, child});
  }
}

bool is_pair_of_leaves(const Query& query) { return query.a->isLeaf() && query.b->isLeaf(); }

bool can_overlap(const Query& query) {
  return query.a == query.b || overlap(query.a->bv, query.b->bv);
}

}  // namespace

struct BoxTree::Tree {
  std::vector<Bundle> bundles;
  std::vector<Node*> leaves;  // of each bundle
  Hierarchy hierarchy;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  // from which lanes see boxes
  std::vector<Query> queries, smaller_queries;

  void refit_bundles(std::span<const BoundingBox> boxes) {
    origin = boxes[0].center();
    parallel_for_each(static_cast<int>(bundles.size()),
                      [&](int b) { bundles[b].refit(boxes, origin, leaves[b]); });
  }

  void find_pairs(const Query& query, std::vector<BoxPair>& pairs) const {
    if (is_pair_of_leaves(query)) {
      find_in(bundles[index_of(query.a)], bundles[index_of(query.b)], pairs);
      return;
    }
    split(query, [&](const Query& smaller) {
      if (can_overlap(smaller)) find_pairs(smaller, pairs);
    });
  }

  static void find_in(const Bundle& a, const Bundle& b, std::vector<BoxPair>& pairs) {
    a.lanes.for_each_overlapping(b.around, [&](int lane) {
      const int i = a.boxes[lane];
      b.lanes.for_each_overlapping(a.lanes.get(lane), [&](int other_lane) {
        const int j = b.boxes[other_lane];
        if (&a != &b || i < j) pairs.push_back({std::min(i, j), std::max(i, j)});
      });
    });
  }

  void search(const Node* node, const BoundingBox& box, std::vector<int>& found) const {
    if (!overlap(node->bv, to_fcl(box))) return;
    if (!node->isLeaf()) {
      for (const Node* child : node->children) search(child, box, found);
      return;
    }
    const Bundle& bundle = bundles[index_of(node)];
    bundle.lanes.for_each_overlapping(BoxSides::around(box, origin),
                                      [&](int lane) { found.push_back(bundle.boxes[lane]); });
  }

  void find_queries() {
    queries.assign(1, {hierarchy.getRoot(), hierarchy.getRoot()});
    for (bool can_be_split = true; can_be_split && queries.size() < query_parts;) {
      smaller_queries.clear();
      can_be_split = false;
      for (const Query& query : queries) {
        if (is_pair_of_leaves(query)) {
          smaller_queries.push_back(query);
          continue;
        }
        can_be_split = true;
        split(query, [&](const Query& part) { smaller_queries.push_back(part); });
      }
      std::swap(queries, smaller_queries);
    }
  }
};

BoxTree::BoxTree(std::span<const BoundingBox> boxes) : tree_(std::make_unique<Tree>()) {
  if (boxes.empty()) return;
  std::vector<Eigen::Vector3d> centres;
  for (const BoundingBox& box : boxes) centres.push_back(box.center());
  split_at_medians(centres, BoxLanes::size,
                   [&](std::span<const int> part) { tree_->bundles.emplace_back(part); });
  for (std::size_t b = 0; b < tree_->bundles.size(); ++b) {
    auto leaf = std::make_unique<Node>();
    leaf->parent = leaf->children[1] = nullptr;
    leaf->data = reinterpret_cast<void*>(static_cast<std::intptr_t>(b));
    tree_->leaves.push_back(leaf.release());  // FCL deletes it
  }
  tree_->refit_bundles(boxes);
  std::vector<Node*> leaves = tree_->leaves;
  tree_->hierarchy.init(leaves);
  tree_->find_queries();
}

BoxTree::~BoxTree() = default;
BoxTree::BoxTree(BoxTree&&) noexcept = default;
BoxTree& BoxTree::operator=(BoxTree&&) noexcept = default;

void BoxTree::refit(std::span<const BoundingBox> boxes) {
  if (boxes.empty()) return;
  tree_->refit_bundles(boxes);
  refit_branches(tree_->hierarchy.getRoot());
  tree_->find_queries();
}

int BoxTree::part_count() const { return static_cast<int>(tree_->queries.size()); }

void BoxTree::find_pairs(int part, std::vector<BoxPair>& pairs) const {
  const Query& query = tree_->queries[part];
  if (can_overlap(query)) tree_->find_pairs(query, pairs);
}

void BoxTree::find_overlapping(const BoundingBox& box, std::vector<int>& found) const {
  if (!tree_->bundles.empty()) tree_->search(tree_->hierarchy.getRoot(), box, found);
}

}  // namespace ringlet
