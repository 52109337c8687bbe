#pragma once

#include <cstddef>
#include <span>

#include "core/couplings.h"
#include "core/named.h"
#include "core/step_start.h"
#include "core/strands.h"

namespace ringlet {

/// A term of the potential that couples vertices of any strands: glue, springs, ties. A scene that
/// names none has none of their stages either.
class CouplingEnergy : public Named {
 public:
  virtual ~CouplingEnergy() = default;

  /// Computes rest data from the strands' rest shape. Called once, before the others.
  virtual void bind(const Strands& strands, const StrandGroups& groups) = 0;
  /// As Energy::vanishes().
  virtual bool vanishes() const { return false; }
  /// May change its rest data, as Energy::begin_step() may.
  virtual void begin_step(const StepStart& start) { (void)start; }
  /// As Energy::changing_data().
  virtual std::span<std::byte> changing_data() { return {}; }
  /// Returns the energy at x, J; adds its terms, whose Hessians are positive semi-definite, unless
  /// null. Results do not depend on the number of threads.
  virtual double add(const VertexField& x, Couplings* couplings) const = 0;
};

}  // namespace ringlet
