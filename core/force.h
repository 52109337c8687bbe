#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/energy.h"
#include "core/state.h"

namespace ringlet {

/// What a force may look at when a step begins.
struct StepStart {
  const State& state;                                 ///< at the beginning of the step
  double dt;                                          ///< s
  std::span<const std::unique_ptr<Energy>> energies;  ///< the elastic potential
};

/// A force that is not an elastic energy: gravity, drag, damping. Within one step it is the minus
/// gradient of an incremental potential in the positions at the end of the step, in which the
/// velocity stands as (x - x_n) / dt.
class Force {
 public:
  virtual ~Force() = default;
  virtual void bind(const Strands& strands, const StrandGroups& groups) = 0;
  virtual void begin_step(const StepStart& start) = 0;
  /// As Energy::add, for the incremental potential and with derivatives with respect to the
  /// vertices.
  virtual double add(int group, std::span<const Vector3<Pack>> x, GroupOutputs outputs) const = 0;
};

}  // namespace ringlet
