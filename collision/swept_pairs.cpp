#include "collision/swept_pairs.h"

#include "collision/detectors/pair_lists.h"

namespace ringlet {

std::vector<EdgePair> SweptPairs::find(std::span<const Eigen::Vector3d> from,
                                       std::span<const Eigen::Vector3d> to, double reach,
                                       const ContactRule& rule) {
  boxes_.place(reach, [&](int edge) {
    BoundingBox box(from[edge]);
    return box.extend(to[edge]).extend(from[edge + 1]).extend(to[edge + 1]);
  });
  std::vector<std::vector<EdgePair>> found(boxes_.part_count());
  parallel_for_each(boxes_.part_count(), [&](int part) {
    boxes_.for_each_pair(part, [&](const EdgePair& pair) {
      if (rule.allows(pair)) found[part].push_back(pair);
    });
  });
  std::vector<EdgePair> pairs;
  merge_sorted(found, pairs);
  return pairs;
}

}  // namespace ringlet
