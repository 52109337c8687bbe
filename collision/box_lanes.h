#pragma once

#include <array>
#include <experimental/simd>
#include <limits>

#include "collision/box_tree.h"

namespace ringlet {

/// The sides of an axis-aligned box.
struct BoxSides {
  std::array<float, 3> low, high;

  /// A box that overlaps none, not even an infinite one.
  static BoxSides none() {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    return {{nan, nan, nan}, {nan, nan, nan}};
  }
  /// A box as seen from an origin, with half the digits, for twice the lanes: rounded outwards.
  static BoxSides around(const BoundingBox& box, const Eigen::Vector3d& origin) {
    BoxSides sides;
    for (int c = 0; c < 3; ++c) {
      const double low = box.min()[c] - origin[c], high = box.max()[c] - origin[c];
      const double grain = 1e-7 * std::max(std::abs(low), std::abs(high));
      sides.low[c] = static_cast<float>(low - grain);
      sides.high[c] = static_cast<float>(high + grain);
    }
    return sides;
  }
};

/// A few boxes side by side in lanes, one next to the other in memory.
class BoxLanes {
 public:
  static constexpr int size = 16;

  void set(int lane, const BoxSides& box) {
    for (int c = 0; c < 3; ++c) {
      low_[c][lane] = box.low[c];
      high_[c][lane] = box.high[c];
    }
  }
  BoxSides get(int lane) const {
    return {{low_[0][lane], low_[1][lane], low_[2][lane]},
            {high_[0][lane], high_[1][lane], high_[2][lane]}};
  }

  /// visit(lane) for every box that overlaps a given one, in order. Boxes that touch overlap.
  template <class Visit>
  void for_each_overlapping(const BoxSides& box, const Visit& visit) const {
    for (int first = 0; first < size; first += lanes) {
      auto near = overlap(0, first, box) && overlap(1, first, box) && overlap(2, first, box);
      while (std::experimental::any_of(near)) {
        const int lane = std::experimental::find_first_set(near);
        near[lane] = false;
        visit(first + lane);
      }
    }
  }

 private:
  using Floats = std::experimental::native_simd<float>;
  static constexpr int lanes = static_cast<int>(Floats::size());
  static_assert(size % lanes == 0);

  [[gnu::always_inline]] Floats::mask_type overlap(int axis, int first, const BoxSides& box) const {
    using std::experimental::vector_aligned;
    return Floats(&low_[axis][first], vector_aligned) <= box.high[axis] &&
           Floats(&high_[axis][first], vector_aligned) >= box.low[axis];
  }

  alignas(64) std::array<std::array<float, size>, 3> low_, high_;
};

}  // namespace ringlet
