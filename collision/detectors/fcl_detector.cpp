// Near pairs of edges by FCL's dynamic AABB tree over chunks of edges: boxes of edges that overlap
// (edge_boxes.h) are measured edge by edge (pair_sieve.h).

#include "collision/detectors/pair_lists.h"
#include "collision/detectors/pair_sieve.h"
#include "collision/edge_boxes.h"
#include "core/registry.h"

namespace ringlet {
namespace {

/// Of some edges that are looked at.
constexpr int edges_a_query = 64;

auto boxes_at(std::span<const Eigen::Vector3d> positions) {
  return [=](int edge) {
    const auto ends = positions.subspan(edge, 2);
    return BoundingBox(ends[0].cwiseMin(ends[1]), ends[0].cwiseMax(ends[1]));
  };
}

class FclDetector final : public ContactDetector {
 public:
  void bind(const Strands& strands) override { boxes_.emplace(strands); }

  void find(std::span<const Eigen::Vector3d> positions, double reach,
            std::vector<EdgePair>& pairs) override {
    boxes_->place(reach, boxes_at(positions));
    find_in_parts(boxes_->part_count(), positions, reach, pairs, [&](int part, PairSieve& sieve) {
      boxes_->for_each_pair(part, [&](const EdgePair& pair) { sieve.add(pair); });
    });
  }

  void find_with(std::span<const int> edges, std::span<const Eigen::Vector3d> positions,
                 double reach, std::vector<EdgePair>& pairs) override {
    const auto box_of = boxes_at(positions);
    boxes_->replace(edges, box_of);
    const int count = static_cast<int>(edges.size());
    const int parts = (count + edges_a_query - 1) / edges_a_query;
    find_in_parts(parts, positions, reach, pairs, [&](int part, PairSieve& sieve) {
      const int begin = part * edges_a_query;
      boxes_->for_each_pair_with(edges.subspan(begin, std::min(edges_a_query, count - begin)),
                                 box_of, [&](const EdgePair& pair) { sieve.add(pair); });
    });
  }

  std::size_t bytes() const override { return (boxes_ ? boxes_->bytes() : 0) + bytes_of(found_); }

 private:
  /// find(part, sieve) adds what may be near.
  template <class Find>
  void find_in_parts(int parts, std::span<const Eigen::Vector3d> positions, double reach,
                     std::vector<EdgePair>& pairs, const Find& find) {
    found_.resize(std::max<std::size_t>(found_.size(), parts));
    parallel_for_each(static_cast<int>(found_.size()), [&](int part) {
      found_[part].clear();
      if (part >= parts) return;
      PairSieve sieve(positions, reach, found_[part]);
      find(part, sieve);
      sieve.flush();
    });
    merge_sorted(found_, pairs);
  }

  std::optional<EdgeBoxes> boxes_;
  // In each part of a search; kept for the memory alone.
  std::vector<std::vector<EdgePair>> found_;
};

}  // namespace

void register_fcl_detector(Registry& registry);
void register_fcl_detector(Registry& registry) {
  registry.of<ContactDetector>().add<NoParameters>(
      "fcl", {"FCL's dynamic AABB tree over chunks of sixteen edges, refitted", "", ""},
      [](const NoParameters&) { return std::make_unique<FclDetector>(); });
}

}  // namespace ringlet
