#include "core/strand_groups.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>

#include "core/bytes.h"

namespace ringlet {
namespace {

/// The bits of a number of ten, two apart.
std::uint32_t spread_bits(std::uint32_t n) {
  n = (n | n << 16) & 0x030000ff;
  n = (n | n << 8) & 0x0300f00f;
  n = (n | n << 4) & 0x030c30c3;
  n = (n | n << 2) & 0x09249249;
  return n;
}

/// Along a Z-order curve through the box of all roots (Morton 1966): strands whose numbers are near
/// each other stand near each other.
std::vector<std::uint32_t> places_on_curve(const Strands& strands) {
  Eigen::AlignedBox3d box;
  for (int s = 0; s < strands.count(); ++s) box.extend(strands.rest_position(strands.first(s)));
  std::vector<std::uint32_t> places(strands.count());
  const double cell = std::max(box.sizes().maxCoeff(), 1e-300) / 1023;
  for (int s = 0; s < strands.count(); ++s) {
    const Eigen::Vector3d root = (strands.rest_position(strands.first(s)) - box.min()) / cell;
    for (int axis = 0; axis < 3; ++axis) {
      places[s] |= spread_bits(static_cast<std::uint32_t>(root[axis])) << axis;
    }
  }
  return places;
}

}  // namespace

StrandGroups::StrandGroups(const Strands& strands, const std::vector<bool>& is_held)
    : slots_(strands.vertex_count()) {
  std::vector<int> order(strands.count());
  std::iota(order.begin(), order.end(), 0);
  const std::vector<std::uint32_t> places = places_on_curve(strands);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return std::pair(strands.size(b), places[a]) < std::pair(strands.size(a), places[b]);
  });
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
