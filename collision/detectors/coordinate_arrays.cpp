#include "collision/detectors/coordinate_arrays.h"

#include "core/parallel.h"

namespace ringlet {

void CoordinateArrays::set(std::span<const Eigen::Vector3d> positions) {
  for (std::vector<double>& array : arrays_) array.resize(positions.size() + lane_count);
  parallel_for_each(static_cast<int>(positions.size()), [&](int v) {
    for (int c = 0; c < 3; ++c) arrays_[c][v] = positions[v][c];
  });
}

}  // namespace ringlet
