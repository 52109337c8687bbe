#pragma once

#include "collision/box_tree.h"

namespace ringlet {

/// How much boxes are grown on every side so that two of them overlap if what they hold is nearer
/// than reach: half of it, and a grain that is larger than the rounding errors of coordinates of
/// that size.
inline double growth(const BoundingBox& box, double reach) {
  const double coordinate =
      std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  return 0.5 * (1 + 1e-6) * reach + 1e-12 * coordinate;
}

}  // namespace ringlet
