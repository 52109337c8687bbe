// A plugin as it should be.
#include "core/contact_energy.h"
#include "core/plugin.h"

namespace {

/// Pushes nothing.
class Nothing final : public ringlet::ContactEnergy {
 public:
  ringlet::DistanceEnergy at(double, double, double) const override { return {}; }
  bool is_barrier() const override { return false; }
};

void register_nothing(ringlet::Registry& registry) {
  registry.of<ringlet::ContactEnergy>().add<ringlet::NoParameters>(
      "nothing", {"for tests", "0", ""},
      [](const ringlet::NoParameters&) { return std::make_unique<Nothing>(); });
}

}  // namespace

RINGLET_PLUGIN(register_nothing);
