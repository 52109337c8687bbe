#include "plugins/render/curves.h"

namespace ringlet {
namespace {

CurvePoint make_point(const Eigen::Vector3d& point, double radius) {
  return {static_cast<float>(point.x()), static_cast<float>(point.y()),
          static_cast<float>(point.z()), static_cast<float>(radius)};
}

/// Where a curve comes from and goes to, if it goes straight on.
CurvePoint beyond(const CurvePoint& end, const CurvePoint& inner) {
  return {2 * end.x - inner.x, 2 * end.y - inner.y, 2 * end.z - inner.z, end.radius};
}

}  // namespace

Eigen::Array4f catmull_rom_slope(float u) {
  return 0.5F * Eigen::Array4f(-3 * u * u + 4 * u - 1, 9 * u * u - 10 * u, -9 * u * u + 8 * u + 1,
                               3 * u * u - 2 * u);
}

Curves make_curves(const StrandShapes& strands, const Eigen::Vector3d& origin) {
  Curves curves;
  Eigen::Index vertex = 0;
  for (std::size_t strand = 0; strand < strands.vertex_counts.size(); ++strand) {
    const int count = strands.vertex_counts[strand];
    const auto first = static_cast<std::uint32_t>(curves.points.size());
    curves.points.emplace_back();
    for (int i = 0; i < count; ++i, ++vertex) {
      curves.points.push_back(make_point(strands.positions.col(vertex) - origin,
                                         strands.radii[static_cast<std::size_t>(vertex)]));
    }
    curves.points.push_back(beyond(curves.points.back(), curves.points[curves.points.size() - 2]));
    curves.points[first] = beyond(curves.points[first + 1], curves.points[first + 2]);
    for (int i = 0; i + 1 < count; ++i) {
      curves.segments.push_back(first + static_cast<std::uint32_t>(i));
      curves.strands.push_back(static_cast<std::uint32_t>(strand));
    }
  }
  return curves;
}

}  // namespace ringlet
