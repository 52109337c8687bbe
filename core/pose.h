#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/named.h"
#include "core/strands.h"

namespace ringlet {

/// Deforms the strands' rest shape into the shape they start from.
class Pose : public Named {
 public:
  virtual ~Pose() = default;
  /// positions: of all vertices, m. pinned_counts: of each strand, vertices from the root that must
  /// stay where they are.
  virtual void apply(const Strands& strands, const std::vector<int>& pinned_counts,
                     std::vector<Eigen::Vector3d>& positions) const = 0;
};

}  // namespace ringlet
