#pragma once

#include <vector>

#include "core/named.h"
#include "core/strands.h"

namespace ringlet {

/// Makes strands in their rest shape.
class StrandSource : public Named {
 public:
  virtual ~StrandSource() = default;
  /// Throws Error with the reason if it cannot (a file that is not what it should be).
  virtual StrandSet generate() const = 0;
};

/// Where a strand stands: its root and the unit direction in which it grows.
struct Root {
  Eigen::Vector3d position;
  Eigen::Vector3d direction;
};

/// Places the roots of generated strands.
class RootSource : public Named {
 public:
  virtual ~RootSource() = default;
  virtual std::vector<Root> place(int count, unsigned seed) const = 0;
};

}  // namespace ringlet
