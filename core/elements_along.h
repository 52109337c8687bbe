#pragma once

#include <algorithm>
#include <span>

#include "core/kernel_derivatives.h"

namespace ringlet {

/// Elements of one strand, which is a lane of a group, side by side: element first + l in lane l;
/// behind the last one, which is before `end`, it follows again.
template <class Kernel>
struct ElementsAlong {
  static constexpr int K = Kernel::vertices;
  using Rest = typename RestLanes<Kernel>::Packs;

  Stencil<Pack, K> stencil;
  Rest rest;

  /// From the rest data and the positions of the group, a row an element and a vertex.
  [[gnu::always_inline]] ElementsAlong(const Rest* rests, std::span<const Vector3<Pack>> x,
                                       int lane, int first, int end) {
    for (int l = 0; l < lane_count; ++l) {
      const int i = std::min(first + l, end - 1);
      for (int n = 0; n < K; ++n) {
        stencil[n].x[l] = x[i + n].x[lane];
        stencil[n].y[l] = x[i + n].y[lane];
        stencil[n].z[l] = x[i + n].z[lane];
      }
      RestLanes<Kernel>::set(rest, l, RestLanes<Kernel>::get(rests[i], lane));
    }
  }
};

}  // namespace ringlet
