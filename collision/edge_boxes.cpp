#include "collision/edge_boxes.h"

namespace ringlet {
namespace {

/// Chunks whose pairs with themselves make one part of the search.
constexpr int chunks_a_part = 256;

}  // namespace

EdgeBoxes::EdgeBoxes(const Strands& strands)
    : chunks_(make_edge_chunks(strands, BoxLanes::size)),
      boxes_(chunks_.size()),
      sides_(chunks_.size()) {
  for (Sides& sides : sides_) {
    for (int lane = 0; lane < BoxLanes::size; ++lane) sides.edges.set(lane, BoxSides::none());
  }
  place(0, [&](int edge) {
    return BoundingBox(strands.rest_position(edge)).extend(strands.rest_position(edge + 1));
  });
}

void EdgeBoxes::refit() {
  if (tree_) {
    tree_->refit(boxes_);
  } else {
    tree_.emplace(boxes_);
  }
}

int EdgeBoxes::chunk_of(int edge) const {
  const auto behind =
      std::upper_bound(chunks_.begin(), chunks_.end(), edge,
                       [](int searched, const EdgeChunk& chunk) { return searched < chunk.first; });
  return static_cast<int>(behind - chunks_.begin()) - 1;
}

// Parts of the tree, which gives pairs of different chunks, and then those of chunks alone.
int EdgeBoxes::part_count() const {
  const int chunks = static_cast<int>(chunks_.size());
  return tree_->part_count() + (chunks + chunks_a_part - 1) / chunks_a_part;
}

void EdgeBoxes::find_chunks(int part, std::vector<BoxPair>& found) const {
  found.clear();
  if (part < tree_->part_count()) {
    tree_->find_pairs(part, found);
    return;
  }
  const int begin = (part - tree_->part_count()) * chunks_a_part;
  const int end = std::min(begin + chunks_a_part, static_cast<int>(chunks_.size()));
  for (int c = begin; c < end; ++c) found.push_back({c, c});
}

}  // namespace ringlet
