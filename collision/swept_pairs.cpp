#include "collision/swept_pairs.h"

#include <algorithm>

#include "core/parallel.h"

namespace ringlet {

void SweptPairs::sweep(std::span<const Eigen::Vector3d> from, std::span<const Eigen::Vector3d> to,
                       double reach) {
  edges_.resize(from.size());
  boxes_.resize(chunks_.size());
  parallel_for_each(static_cast<int>(chunks_.size()), [&](int c) {
    boxes_[c].setEmpty();
    for (int e = chunks_[c].first; e < chunks_[c].first + chunks_[c].edges; ++e) {
      edges_[e].setEmpty();
      for (const int v : {e, e + 1}) edges_[e].extend(from[v]).extend(to[v]);
      edges_[e].min().array() -= reach / 2;
      edges_[e].max().array() += reach / 2;
      boxes_[c].extend(edges_[e]);
    }
  });
}

std::vector<EdgePair> SweptPairs::find(std::span<const Eigen::Vector3d> from,
                                       std::span<const Eigen::Vector3d> to, double reach,
                                       const ContactRule& rule) {
  sweep(from, to, reach);
  if (tree_) {
    tree_->refit(boxes_);
  } else {
    tree_.emplace(boxes_);
  }
  // The last part is that of the chunks with themselves.
  const int parts = tree_->part_count();
  std::vector<std::vector<EdgePair>> found(parts + 1);
  parallel_for_each(parts, [&](int part) {
    std::vector<BoxPair> near;
    tree_->find_pairs(part, near);
    for (const BoxPair& pair : near) add_near_edges(pair, rule, found[part]);
  });
  for (int c = 0; c < static_cast<int>(chunks_.size()); ++c) {
    add_near_edges({c, c}, rule, found.back());
  }
  std::vector<EdgePair> pairs;
  for (const auto& part : found) pairs.insert(pairs.end(), part.begin(), part.end());
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

void SweptPairs::add_near_edges(const BoxPair& pair, const ContactRule& rule,
                                std::vector<EdgePair>& pairs) const {
  const EdgeChunk &one = chunks_[pair.first], &other = chunks_[pair.second];
  for (int a = one.first; a < one.first + one.edges; ++a) {
    for (int b = std::max(other.first, a + 1); b < other.first + other.edges; ++b) {
      if (edges_[a].intersects(edges_[b]) && rule.allows({a, b})) pairs.push_back({a, b});
    }
  }
}

}  // namespace ringlet
