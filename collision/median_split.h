#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

namespace ringlet {

/// Splits the points at medians of their coordinates until no part has more than `size`, and calls
/// visit(part) for each: neighbours, as indices. All parts but few are full.
template <class Visit>
void split_at_medians(std::span<const Eigen::Vector3d> points, std::span<int> part,
                      std::size_t size, const Visit& visit) {
  if (part.size() <= size) {
    if (!part.empty()) visit(std::span<const int>(part));
    return;
  }
  Eigen::AlignedBox3d box;
  for (const int p : part) box.extend(points[p]);
  int axis = 0;
  box.sizes().maxCoeff(&axis);
  // A multiple of the size on one side keeps the parts full.
  const std::size_t half = (part.size() / 2 + size - 1) / size * size;
  std::nth_element(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(half), part.end(),
                   [&](int a, int b) { return points[a][axis] < points[b][axis]; });
  split_at_medians(points, part.first(half), size, visit);
  split_at_medians(points, part.subspan(half), size, visit);
}

/// The same for all points.
template <class Visit>
void split_at_medians(std::span<const Eigen::Vector3d> points, std::size_t size,
                      const Visit& visit) {
  std::vector<int> all(points.size());
  std::iota(all.begin(), all.end(), 0);
  split_at_medians(points, std::span(all), size, visit);
}

}  // namespace ringlet
