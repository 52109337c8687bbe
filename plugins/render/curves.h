#pragma once

#include <cstdint>
#include <vector>

namespace ringlet {

/// A point that a curve passes through, and the curve's radius there, m: what Embree takes.
struct alignas(16) CurvePoint {
  float x, y, z, radius;
};

/// Catmull-Rom curves. A segment goes from the second to the third of four points in a row, of
/// which it names the first; so each curve has one point more at each end.
struct Curves {
  std::vector<CurvePoint> points;
  std::vector<std::uint32_t> segments;
  int per_strand = 1;                          ///< curves of each simulated strand
  std::vector<std::uint32_t> strand_segments;  ///< first segment of each strand, and their number

  /// The number of the curve that a segment is of, counted over all.
  std::uint64_t curve_of(std::uint32_t segment) const;
  /// The direction of a segment where its parameter is u in [0, 1]; not of length 1.
  void derivative(std::uint32_t segment, float u, float direction[3]) const;
};

}  // namespace ringlet
