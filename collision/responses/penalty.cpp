// The quadratic penalty of "Lifted Curls" (Shi et al., SCA 2023), where contacts are implicit
// springs. With the thickness h and the stiffness k:
//
//     E(d) = k/2 (h - d)^2  for d < h, else 0
//
// The force k (h - d) is never more than k h between edges: what pushes harder passes through.

#include "core/contact_energy.h"
#include "core/registry.h"

namespace ringlet {
namespace {

class Penalty final : public ContactEnergy {
 public:
  DistanceEnergy at(double distance, double thickness, double stiffness) const override {
    const double depth = thickness - distance;
    if (!(depth > 0)) return {};
    return {0.5 * stiffness * depth * depth, -stiffness * depth, stiffness};
  }
  bool is_barrier() const override { return false; }
};

}  // namespace

void register_penalty(Registry& registry);
void register_penalty(Registry& registry) {
  registry.of<ContactEnergy>().add<NoParameters>(
      "penalty",
      {"a spring that is compressed by what comes nearer than the thickness", "k/2 (h - d)^2",
       "Shi et al., Lifted Curls, SCA 2023"},
      [](const NoParameters&) { return std::make_unique<Penalty>(); });
}

}  // namespace ringlet
