#include "core/strand_groups.h"

#include <algorithm>
#include <numeric>
#include <span>

#include "core/bytes.h"

namespace ringlet {

StrandGroups::StrandGroups(const Strands& strands, const std::vector<bool>& is_held)
    : slots_(strands.vertex_count()) {
  std::vector<int> order(strands.count());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return strands.size(a) > strands.size(b); });
  const auto first_held = std::stable_partition(
      order.begin(), order.end(), [&](int s) { return is_held.empty() || !is_held[s]; });
  add_groups(strands, {order.begin(), first_held});
  add_groups(strands, {first_held, order.end()});
}

void StrandGroups::add_groups(const Strands& strands, std::span<const int> order) {
  for (std::size_t begin = 0; begin < order.size(); begin += lane_count) {
    StrandGroup group{rows_, strands.size(order[begin]), {}};
    group.strands.fill(-1);
    vertex_at_.resize((rows_ + group.vertices) * lane_count, -1);
    for (int lane = 0; lane < lane_count && begin + lane < order.size(); ++lane) {
      const int strand = group.strands[lane] = order[begin + lane];
      for (int i = 0; i < strands.size(strand); ++i) {
        slots_[strands.first(strand) + i] = {rows_ + i, lane};
        vertex_at_[(rows_ + i) * lane_count + lane] = strands.first(strand) + i;
      }
    }
    group_of_row_.insert(group_of_row_.end(), group.vertices, count());
    rows_ += group.vertices;
    groups_.push_back(group);
  }
}

std::size_t StrandGroups::bytes() const {
  return bytes_of(groups_) + bytes_of(slots_) + bytes_of(group_of_row_) + bytes_of(vertex_at_);
}

}  // namespace ringlet
