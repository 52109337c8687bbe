#pragma once

#include <Eigen/Core>
#include <vector>

namespace ringlet {

/// Strands at one moment, m: their vertices one after the other, from root to tip.
struct StrandShapes {
  std::vector<int> vertex_counts;  ///< of each strand
  std::vector<double> radii;       ///< one a vertex
  Eigen::Matrix3Xd positions;      ///< column i = vertex i
};

}  // namespace ringlet
