#pragma once

#include <cstdint>
#include <vector>

#include "plugins/render/strand_shapes.h"

namespace ringlet {

/// A point that a curve passes through, and the curve's radius there, m: what Embree takes.
struct alignas(16) CurvePoint {
  float x, y, z, radius;
};

/// Strands as Catmull-Rom curves. A segment goes from the second to the third of four points in a
/// row, of which it names the first; so each curve has one point more at each end.
struct Curves {
  std::vector<CurvePoint> points;
  std::vector<std::uint32_t> segments;
  std::vector<std::uint32_t> strands;  ///< that each segment is of
};

/// The curves through the vertices of strands, relative to an origin.
Curves make_curves(const StrandShapes& strands, const Eigen::Vector3d& origin);

/// How much each of four points counts for the direction of a Catmull-Rom curve at u in [0, 1].
Eigen::Array4f catmull_rom_slope(float u);

}  // namespace ringlet
