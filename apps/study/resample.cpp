#include "apps/study/resample.h"

#include <algorithm>
#include <string>

#include "core/error.h"

namespace ringlet {

Resampling::Resampling(const std::vector<int>& from_counts, const std::vector<int>& to_counts) {
  if (from_counts.size() != to_counts.size()) {
    throw Error("it has " + std::to_string(to_counts.size()) + " strands, the reference " +
                std::to_string(from_counts.size()));
  }
  int first = 0;
  for (std::size_t strand = 0; strand < to_counts.size(); ++strand) {
    const int edges = from_counts[strand] - 1, wanted = to_counts[strand] - 1;
    for (int i = 0; i <= wanted; ++i) {
      // In whole numbers, so that a vertex that both have is met exactly.
      const int edge = std::min(i * edges / wanted, edges - 1);
      const double along = static_cast<double>(i) * edges / wanted - edge;
      places_.push_back({first + edge, along});
    }
    first += from_counts[strand];
  }
}

Eigen::Matrix3Xd Resampling::operator()(const Eigen::Matrix3Xd& positions) const {
  Eigen::Matrix3Xd resampled(3, static_cast<Eigen::Index>(places_.size()));
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const auto [vertex, fraction] = places_[i];
    resampled.col(static_cast<Eigen::Index>(i)) =
        fraction == 0 ? Eigen::Vector3d(positions.col(vertex))
                      : Eigen::Vector3d((1 - fraction) * positions.col(vertex) +
                                        fraction * positions.col(vertex + 1));
  }
  return resampled;
}

}  // namespace ringlet
