// Bending (math.md, section 2; Shi et al., "Lifted Curls", SCA 2023):
//
//     E = k/2 (theta - theta0)^2,  k = EI / lbar

#include "energies/angle_bending.h"

namespace ringlet {

namespace {

struct QuadraticLaw {
  template <class S>
  static S rest(const TurningAngle<S>& turning) {
    return turning.radians;
  }
  template <class S>
  static S value(const TurningAngle<S>& turning, const S& rest) {
    const S difference = turning.radians - rest;
    return S(0.5) * difference * difference;
  }
  template <class S>
  static S first(const TurningAngle<S>& turning, const S& rest) {
    return turning.radians - rest;
  }
  template <class S>
  static S second(const TurningAngle<S>&, const S&) {
    return S(1);
  }
};

}  // namespace

void register_bending(Registry& registry);
void register_bending(Registry& registry) {
  register_energy<AngleBending<QuadraticLaw>>(
      registry, "bending",
      {"resistance of the hinges to a change of the angle between their edges",
       "k/2 (theta - theta0)^2, k = EI / lbar", "math.md, section 2; Lifted Curls, SCA 2023"});
}

}  // namespace ringlet
