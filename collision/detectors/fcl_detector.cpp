// Near pairs of edges by FCL's dynamic AABB tree over chunks of edges: boxes of edges that overlap
// (edge_boxes.h) are measured edge by edge (pair_sieve.h).

#include "collision/detectors/pair_lists.h"
#include "collision/detectors/pair_sieve.h"
#include "collision/edge_boxes.h"
#include "core/registry.h"

namespace ringlet {
namespace {

class FclDetector final : public ContactDetector {
 public:
  void bind(const Strands& strands) override { boxes_.emplace(strands); }

  void find(std::span<const Eigen::Vector3d> positions, double reach,
            std::vector<EdgePair>& pairs) override {
    boxes_->place(reach, [&](int edge) {
      const auto ends = positions.subspan(edge, 2);
      return BoundingBox(ends[0].cwiseMin(ends[1]), ends[0].cwiseMax(ends[1]));
    });
    found_.resize(boxes_->part_count());
    parallel_for_each(boxes_->part_count(), [&](int part) {
      found_[part].clear();
      PairSieve sieve(positions, reach, found_[part]);
      boxes_->for_each_pair(part, [&](const EdgePair& pair) { sieve.add(pair); });
      sieve.flush();
    });
    merge_sorted(found_, pairs);
  }

  std::size_t bytes() const override { return (boxes_ ? boxes_->bytes() : 0) + bytes_of(found_); }

 private:
  std::optional<EdgeBoxes> boxes_;
  std::vector<std::vector<EdgePair>> found_;  // in each part of a search; kept for the memory alone
};

}  // namespace

void register_fcl_detector(Registry& registry);
void register_fcl_detector(Registry& registry) {
  registry.of<ContactDetector>().add<NoParameters>(
      "fcl", {"FCL's dynamic AABB tree over chunks of sixteen edges, refitted", "", ""},
      [](const NoParameters&) { return std::make_unique<FclDetector>(); });
}

}  // namespace ringlet
