#pragma once

#include <span>

#include "core/energy.h"
#include "core/named.h"
#include "core/step_start.h"

namespace ringlet {

/// A force that is not an elastic energy: gravity, drag, damping. Within one step it is the minus
/// gradient of an incremental potential in the positions at the end of the step, in which the
/// velocity stands as (x - x_n) / dt.
class Force : public Named {
 public:
  virtual ~Force() = default;
  virtual void bind(const Strands& strands, const StrandGroups& groups) = 0;
  virtual void begin_step(const StepStart& start) = 0;
  /// As Energy::add, for the incremental potential and with derivatives with respect to the
  /// vertices.
  virtual double add(int group, std::span<const Vector3<Pack>> x, GroupOutputs outputs) const = 0;
};

}  // namespace ringlet
