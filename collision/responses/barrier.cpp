// The logarithmic barrier of "Incremental Potential Contact" (Li, Ferguson, Schneider, Langlois,
// Zorin, Panozzo, Jiang, Kaufman, SIGGRAPH 2020, equation 6), scaled so that its stiffness k is one
// in N/m. With the thickness h:
//
//     E(d) = -k/2 (d - h)^2 ln(d/h)                         for d < h, else 0
//     E'   = -k/2 (d - h) (2 ln(d/h) + (d - h)/d)
//     E''  = -k/2 (2 ln(d/h) + 4 (d - h)/d - (d - h)^2/d^2) > 0
//
// It has two continuous derivatives at h, and no bound at 0. At h/2 the force is 0.6 k h; that of
// the penalty is 0.5 k h.

#include <cmath>
#include <limits>

#include "core/contact_energy.h"
#include "core/registry.h"

namespace ringlet {
namespace {

class Barrier final : public ContactEnergy {
 public:
  DistanceEnergy at(double distance, double thickness, double stiffness) const override {
    if (!(distance < thickness)) return {};
    if (!(distance > 0)) {
      return {std::numeric_limits<double>::infinity(), 0, 0};
    }
    const double logarithm = std::log(distance / thickness);
    const double less = distance - thickness, ratio = less / distance;
    return {-0.5 * stiffness * less * less * logarithm,
            -0.5 * stiffness * less * (2 * logarithm + ratio),
            -0.5 * stiffness * (2 * logarithm + 4 * ratio - ratio * ratio)};
  }
  bool is_barrier() const override { return true; }
};

}  // namespace

void register_barrier(Registry& registry);
void register_barrier(Registry& registry) {
  registry.of<ContactEnergy>().add<NoParameters>(
      "barrier",
      {"grows without bound as the distance falls to zero", "-k/2 (d - h)^2 ln(d/h)",
       "Li et al., Incremental Potential Contact, SIGGRAPH 2020, equation 6"},
      [](const NoParameters&) { return std::make_unique<Barrier>(); });
}

}  // namespace ringlet
