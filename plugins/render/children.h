#pragma once

#include <Eigen/Core>
#include <vector>

#include "plugins/render/curves.h"

namespace ringlet {

/// Strands at one moment, m: their vertices one after the other, from root to tip.
struct StrandShapes {
  std::vector<int> vertex_counts;  ///< of each strand
  std::vector<double> radii;       ///< one a vertex
  Eigen::Matrix3Xd positions;      ///< column i = vertex i
};

/// How hairs are interpolated around each strand.
struct ChildParameters {
  int count = 0;         ///< around each strand; 0: the strand itself
  double radius = 4e-5;  ///< of a child, m
  double spread = 1;     ///< radius of the bundle, in radii of the strand
  double frizz = 0;      ///< in [0, 1]: the part of its offset that wanders along a child
};

/// The curves that a picture shows, relative to an origin. Children stay within the radius of their
/// strand, times the spread, of the strand's own curve: their offsets are constant in a frame that
/// is moved along the strand without twist, but for the frizz; each ends a little before the tip.
/// The same strands and parameters give the same curves. Throws Error if there are more points
/// than numbers of 32 bits can count.
Curves make_curves(const StrandShapes& strands, const ChildParameters& parameters,
                   const Eigen::Vector3d& origin);

}  // namespace ringlet
