#pragma once

#include <span>

#include "core/strand_bands.h"
#include "core/strands.h"
#include "core/vertex_field.h"

namespace ringlet {

/// Where a term of the potential adds its derivatives for one group of strands; what is empty is
/// not wanted.
struct GroupOutputs {
  std::span<Vector3<Pack>> gradient;
  GroupBands hessian;
};

/// One term of the elastic potential of the strands: a function of their positions alone.
class Energy {
 public:
  virtual ~Energy() = default;

  /// Computes rest data from the strands' rest shape. Called once, before add().
  virtual void bind(const Strands& strands, const StrandGroups& groups) = 0;

  /// Returns the energy of a group of strands at positions x, J. Adds its gradient, dE/dx, and its
  /// Hessian, made positive semi-definite by the energy's filter, where they are wanted.
  /// Called from several threads at once, for different groups.
  virtual double add(int group, std::span<const Vector3<Pack>> x, GroupOutputs outputs) const = 0;
};

}  // namespace ringlet
