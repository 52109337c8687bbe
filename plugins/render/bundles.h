#pragma once

#include <cstdint>
#include <vector>

#include "plugins/render/child.h"

namespace ringlet {

/// Hairs traced side by side, one in each lane of a register or two of the machine.
constexpr int hair_lanes = 16;

/// A point of each hair of a bundle, m.
struct alignas(64) LanePoints {
  float x[hair_lanes], y[hair_lanes], z[hair_lanes];

  Eigen::Vector3f of(int lane) const { return {x[lane], y[lane], z[lane]}; }
};

/// Children in bundles of neighbours that run along the same strand, as Catmull-Rom curves. A
/// segment of a bundle goes from the second to the third of four points in a row.
///
/// Embree's own curves would need a tree with a leaf for every segment of every hair; building it
/// takes most of the time of a picture. A bundle is one leaf for up to 16 hairs.
struct Bundles {
  std::vector<LanePoints> points;
  std::vector<float> radii;  ///< m, one a point: all hairs of a bundle are as thick
  struct Segment {
    std::uint32_t point;   ///< the first of the four
    std::uint32_t bundle;  ///< counted over all strands
    std::uint32_t vertex;  ///< of the strand, that the segment begins at
  };
  std::vector<Segment> segments;
  /// Where each hair ends, one after the other in the lanes of each bundle: at 2.5 in the middle of
  /// the third segment. Lanes without a hair end before they begin.
  std::vector<float> ends;
};

/// The children of all strands, relative to an origin. Without strays they are within the radius of
/// the strand, times the spread, of the curve through its vertices. The same input gives the same
/// bundles. Throws Error if they cannot be counted with 32 bits.
Bundles make_bundles(const StrandShapes& strands, const ChildParameters& parameters,
                     const Eigen::Vector3d& origin);

}  // namespace ringlet
