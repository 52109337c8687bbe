#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/registry.h"

namespace ringlet {

/// One thing that an energy claims, and the worst that was seen of it.
struct Claim {
  std::string text;
  double allowed;                ///< the largest relative error that is rounding
  double worst = 0;              ///< NaN: something was not finite
  std::string worst_state = {};  ///< where the worst was seen
  int states = 0;                ///< how many were tried

  void see(double error, const std::string& state);
  bool holds() const { return states > 0 && worst <= allowed; }
};

/// Makes an energy with further keys of its parameters; null where it does not know such a key or
/// value.
using EnergyMaker = std::function<std::unique_ptr<Energy>(const Json& keys)>;

/// The energy that a scene chooses by its name or by {"type": NAME, ...}. Throws InvalidInput if
/// there is no such energy, or its parameters are wrong. The registry must outlive it.
EnergyMaker energy_maker(const Registry& registry, const Json& choice);

struct VerifyOptions {
  std::uint64_t seed = 1;
  int trials = 6;  ///< random states of each kind
};

/// Tries everything an Energy promises: derivatives against differences, symmetry, invariance,
/// equilibrium at rest, what each filter claims, lanes against plain doubles, degenerate states.
/// Strands have edges of about 1 m and of about 1 mm.
std::vector<Claim> verify_energy(const EnergyMaker& make, const VerifyOptions& options);

}  // namespace ringlet
