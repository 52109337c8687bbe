#pragma once

#include <Eigen/Core>
#include <vector>

namespace ringlet {

/// Positions of strands at other vertices of the same strands.
class Resampling {
 public:
  /// From strands with these vertices to ones with those, at equal fractions of their number of
  /// edges. Throws Error if they are not equally many.
  Resampling(const std::vector<int>& from_counts, const std::vector<int>& to_counts);

  /// Linear along the strands; where the counts are equal, the positions themselves.
  Eigen::Matrix3Xd operator()(const Eigen::Matrix3Xd& positions) const;

 private:
  struct Place {
    int vertex;       ///< of the edge's beginning
    double fraction;  ///< along the edge
  };
  std::vector<Place> places_;
};

}  // namespace ringlet
