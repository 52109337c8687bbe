#pragma once

#include "core/contact_energy.h"
#include "core/plugin.h"

namespace ringlet {

/// Pushes nothing.
class Nothing final : public ContactEnergy {
 public:
  DistanceEnergy at(double, double, double) const override { return {}; }
  bool is_barrier() const override { return false; }
};

inline void register_nothing(Registry& registry) {
  registry.of<ContactEnergy>().add<NoParameters>(
      "nothing", {"for tests", "0", ""},
      [](const NoParameters&) { return std::make_unique<Nothing>(); });
}

}  // namespace ringlet
