#include "plugins/render/curves.h"

#include <algorithm>

namespace ringlet {

std::uint64_t Curves::curve_of(std::uint32_t segment) const {
  const auto after = std::upper_bound(strand_segments.begin(), strand_segments.end(), segment);
  const auto strand = static_cast<std::uint64_t>(after - strand_segments.begin()) - 1;
  const std::uint32_t first = strand_segments[strand];
  const std::uint32_t of_each =
      (strand_segments[strand + 1] - first) / static_cast<std::uint32_t>(per_strand);
  return strand * static_cast<std::uint64_t>(per_strand) + (segment - first) / of_each;
}

void Curves::derivative(std::uint32_t segment, float u, float direction[3]) const {
  // Of the basis ((-u^3 + 2u^2 - u), (3u^3 - 5u^2 + 2), (-3u^3 + 4u^2 + u), (u^3 - u^2)) / 2.
  const float weights[4] = {0.5F * (-3 * u * u + 4 * u - 1), 0.5F * (9 * u * u - 10 * u),
                            0.5F * (-9 * u * u + 8 * u + 1), 0.5F * (3 * u * u - 2 * u)};
  const CurvePoint* point = &points[segments[segment]];
  std::fill(direction, direction + 3, 0.0F);
  for (int i = 0; i < 4; ++i) {
    direction[0] += weights[i] * point[i].x;
    direction[1] += weights[i] * point[i].y;
    direction[2] += weights[i] * point[i].z;
  }
}

}  // namespace ringlet
