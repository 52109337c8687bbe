#include "collision/box_tree.h"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/narrowphase/collision_object.h>
#include <tbb/parallel_sort.h>

namespace ringlet {
namespace {

// FCL's tree holds collision objects; these have no shape but their bounding box.
void place(fcl::CollisionObjectd& object, fcl::CollisionGeometryd& geometry,
           const BoundingBox& box) {
  geometry.aabb_local = fcl::AABBd(box.min(), box.max());
  object.computeAABB();
}

}  // namespace

struct BoxTree::Tree {
  std::vector<std::shared_ptr<fcl::Boxd>> geometries;
  std::vector<fcl::CollisionObjectd> objects;
  fcl::DynamicAABBTreeCollisionManagerd manager;

  int index(const fcl::CollisionObjectd* object) const {
    return static_cast<int>(object - objects.data());
  }
};

BoxTree::BoxTree(std::span<const BoundingBox> boxes) : tree_(std::make_unique<Tree>()) {
  tree_->objects.reserve(boxes.size());
  std::vector<fcl::CollisionObjectd*> pointers;
  for (const BoundingBox& box : boxes) {
    tree_->geometries.push_back(std::make_shared<fcl::Boxd>());
    tree_->objects.emplace_back(tree_->geometries.back());
    place(tree_->objects.back(), *tree_->geometries.back(), box);
    pointers.push_back(&tree_->objects.back());
  }
  tree_->manager.registerObjects(pointers);
  tree_->manager.setup();
}

BoxTree::~BoxTree() = default;

void BoxTree::refit(std::span<const BoundingBox> boxes) {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    place(tree_->objects[i], *tree_->geometries[i], boxes[i]);
  }
  tree_->manager.update();
}

std::vector<BoxPair> BoxTree::overlapping_pairs() const {
  struct Search {
    const Tree& tree;
    std::vector<BoxPair> pairs;
  } search{*tree_, {}};
  const auto collect = [](fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* data) {
    auto& found = *static_cast<Search*>(data);
    const int i = found.tree.index(a), j = found.tree.index(b);
    found.pairs.push_back({std::min(i, j), std::max(i, j)});
    return false;
  };
  tree_->manager.collide(&search, collect);
  // The shape of FCL's tree depends on addresses; the order of what is found must not.
  tbb::parallel_sort(search.pairs.begin(), search.pairs.end(),
                     [](const BoxPair& a, const BoxPair& b) {
                       return a.first != b.first ? a.first < b.first : a.second < b.second;
                     });
  return std::move(search.pairs);
}

void BoxTree::find_overlapping(const BoundingBox& box, std::vector<int>& found) const {
  struct Search {
    const Tree& tree;
    std::vector<int>& found;
  } search{*tree_, found};
  // FCL hands over the tree's object first, then the query.
  const auto collect = [](fcl::CollisionObjectd* object, fcl::CollisionObjectd*, void* data) {
    auto& results = *static_cast<Search*>(data);
    results.found.push_back(results.tree.index(object));
    return false;
  };
  const auto geometry = std::make_shared<fcl::Boxd>();
  fcl::CollisionObjectd query(geometry);
  place(query, *geometry, box);
  tree_->manager.collide(&query, &search, collect);
}

}  // namespace ringlet
