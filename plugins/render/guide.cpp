#include "plugins/render/guide.h"

#include <algorithm>
#include <numeric>

namespace ringlet {

Guide::Guide(const StrandShapes& strands, int strand, int first_vertex)
    : strand_(strand),
      count_(strands.vertex_counts[strand]),
      vertices_(strands.positions.middleCols(first_vertex, count_)),
      radii_(&strands.radii[first_vertex]),
      frames_(parallel_frames(vertices_)),
      mean_radius_(std::accumulate(radii_, radii_ + count_, 0.0) / count_),
      mean_edge_(0) {
  for (int i = 1; i < count_; ++i) {
    mean_edge_ += (vertices_.col(i) - vertices_.col(i - 1)).norm() / (count_ - 1);
  }
}

// Catmull-Rom; at the ends it goes straight on.
Eigen::Vector3d Guide::curve_at(int i, int j, double u) const {
  const Eigen::Vector3d a = vertices_.col(i), b = vertices_.col(j);
  const Eigen::Vector3d before = i > 0 ? Eigen::Vector3d(vertices_.col(i - 1)) : 2 * a - b;
  const Eigen::Vector3d after = j + 1 < count_ ? Eigen::Vector3d(vertices_.col(j + 1)) : 2 * b - a;
  const double v = 1 - u;
  return 0.5 * (-u * v * v * before + (2 + u * u * (3 * u - 5)) * a +
                (2 + v * v * (3 * v - 5)) * b - v * u * u * after);
}

Guide::Place Guide::at(double t) const {
  const int i = std::clamp(static_cast<int>(t), 0, std::max(0, count_ - 2));
  const int j = std::min(i + 1, count_ - 1);
  const double u = t - i, v = 1 - u;
  return {curve_at(i, j, u), v * frames_.first[i] + u * frames_.first[j],
          v * frames_.second[i] + u * frames_.second[j], v * radii_[i] + u * radii_[j]};
}

}  // namespace ringlet
