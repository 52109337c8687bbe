#pragma once

#include <span>

#include "core/energy.h"
#include "core/named.h"
#include "core/step_start.h"

namespace ringlet {

/// A force that is not an elastic energy: gravity, drag, damping. Within one step it is the minus
/// gradient of an incremental potential in the positions x at the end of the step, in which the
/// velocity is that of StepStart::velocity.
class Force : public Named {
 public:
  virtual ~Force() = default;
  virtual void bind(const Strands& strands, const StrandGroups& groups) = 0;
  /// As Energy::vanishes().
  virtual bool vanishes() const { return false; }
  /// False promises that add() never adds to the Hessian: rows of the matrix are complete without
  /// it then.
  virtual bool has_hessian() const { return true; }
  virtual void begin_step(const StepStart& start) = 0;
  /// As Energy::changing_data(), of what does not follow from StepStart alone.
  virtual std::span<std::byte> changing_data() { return {}; }
  /// As Energy::add, for the incremental potential and with derivatives with respect to the
  /// vertices.
  virtual double add(int group, std::span<const Vector3<Pack>> x, GroupOutputs outputs) const = 0;
};

}  // namespace ringlet
