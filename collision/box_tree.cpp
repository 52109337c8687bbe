#include "collision/box_tree.h"

#include <fcl/broadphase/detail/hierarchy_tree.h>
#include <fcl/math/bv/AABB.h>

#include <cstdint>

#include "core/parallel.h"

namespace ringlet {
namespace {

// The tree itself, of which FCL's broad phase managers are made: these add a collision object a
// box, a hash table to find its leaf, and a query of one thread.
using Hierarchy = fcl::detail::HierarchyTree<fcl::AABBd>;
using Node = Hierarchy::NodeType;

// Enough parts that threads end at about the same time.
constexpr std::size_t subtree_parts = 64, query_parts = 512;

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

void refit_subtree(Node* node) {
  if (node->isLeaf()) return;
  refit_subtree(node->children[0]);
  refit_subtree(node->children[1]);
  unite_children(node);
}

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
    if (a->isLeaf()) return;
    visit(Query{a->children[0], a->children[0]});
    visit(Query{a->children[1], a->children[1]});
    visit(Query{a->children[0], a->children[1]});
  } else if (b->isLeaf() || (!a->isLeaf() && a->bv.size() > b->bv.size())) {
    for (const Node* child : a->children) visit(Query{child, b});
  } else {
    for (const Node* child : b->children) visit(Query{a, child});
  }
}

bool is_pair_of_leaves(const Query& query) {
  return query.a != query.b && query.a->isLeaf() && query.b->isLeaf();
}

bool can_overlap(const Query& query) {
  return query.a == query.b || overlap(query.a->bv, query.b->bv);
}

void search(const Query& query, std::vector<BoxPair>& pairs) {
  if (is_pair_of_leaves(query)) {
    const int i = index_of(query.a), j = index_of(query.b);
    pairs.push_back({std::min(i, j), std::max(i, j)});
    return;
  }
  split(query, [&](const Query& smaller) {
    if (can_overlap(smaller)) search(smaller, pairs);
  });
}

void search(const Node* node, const fcl::AABBd& box, std::vector<int>& found) {
  if (!overlap(node->bv, box)) return;
  if (node->isLeaf()) {
    found.push_back(index_of(node));
  } else {
    for (const Node* child : node->children) search(child, box, found);
  }
}

}  // namespace

struct BoxTree::Tree {
  std::vector<Node*> leaves;  // of each box
  Hierarchy hierarchy;
  std::vector<Node*> subtrees;  // that threads refit
  std::vector<Node*> top;       // the nodes above them, children behind their parents
  std::vector<Query> queries;

  void find_subtrees() {
    subtrees.push_back(hierarchy.getRoot());
    for (std::size_t n = 0; n < subtrees.size() && subtrees.size() < n + subtree_parts; ++n) {
      Node* const node = subtrees[n];
      top.push_back(node);
      if (!node->isLeaf()) subtrees.insert(subtrees.end(), node->children, node->children + 2);
    }
    subtrees.erase(subtrees.begin(), subtrees.begin() + static_cast<std::ptrdiff_t>(top.size()));
  }

  void refit() {
    parallel_for_each(static_cast<int>(subtrees.size()),
                      [&](int n) { refit_subtree(subtrees[n]); });
    for (auto node = top.rbegin(); node != top.rend(); ++node) {
      if (!(*node)->isLeaf()) unite_children(*node);
    }
  }

  void find_queries() {
    queries = {{hierarchy.getRoot(), hierarchy.getRoot()}};
    for (bool can_be_split = true; can_be_split && queries.size() < query_parts;) {
      std::vector<Query> smaller;
      can_be_split = false;
      for (const Query& query : queries) {
        if (is_pair_of_leaves(query)) {
          smaller.push_back(query);
          continue;
        }
        can_be_split = true;
        split(query, [&](const Query& part) { smaller.push_back(part); });
      }
      queries = std::move(smaller);
    }
  }
};

BoxTree::BoxTree(std::span<const BoundingBox> boxes) : tree_(std::make_unique<Tree>()) {
  if (boxes.empty()) return;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    auto leaf = std::make_unique<Node>();
    leaf->bv = to_fcl(boxes[i]);
    leaf->parent = leaf->children[1] = nullptr;
    leaf->data = reinterpret_cast<void*>(static_cast<std::intptr_t>(i));
    tree_->leaves.push_back(leaf.release());  // FCL deletes it
  }
  std::vector<Node*> leaves = tree_->leaves;
  tree_->hierarchy.init(leaves);
  tree_->find_subtrees();
  tree_->find_queries();
}

BoxTree::~BoxTree() = default;
BoxTree::BoxTree(BoxTree&&) noexcept = default;
BoxTree& BoxTree::operator=(BoxTree&&) noexcept = default;

void BoxTree::refit(std::span<const BoundingBox> boxes) {
  if (boxes.empty()) return;
  for (std::size_t i = 0; i < boxes.size(); ++i) tree_->leaves[i]->bv = to_fcl(boxes[i]);
  tree_->refit();
  tree_->find_queries();
}

int BoxTree::part_count() const { return static_cast<int>(tree_->queries.size()); }

void BoxTree::find_pairs(int part, std::vector<BoxPair>& pairs) const {
  const Query& query = tree_->queries[part];
  if (can_overlap(query)) search(query, pairs);
}

void BoxTree::find_overlapping(const BoundingBox& box, std::vector<int>& found) const {
  if (!tree_->leaves.empty()) search(tree_->hierarchy.getRoot(), to_fcl(box), found);
}

}  // namespace ringlet
