// Bending by the curvature of discrete elastic rods (Bergou et al., "Discrete Elastic Rods",
// SIGGRAPH 2008; math.md, section 2):
//
//     E = k/2 (kappa - kappa0)^2,  kappa = 2 tan(phi/2),  phi = pi - theta,  k = EI / lbar
//
// A fold, phi = pi, would take infinite energy.

#include "energies/angle_bending.h"

namespace ringlet {

namespace {

// dkappa/dphi = 1 + tan^2(phi/2), d2kappa/dphi2 = tan(phi/2) dkappa/dphi.
struct TangentLaw {
  template <class S>
  static S rest(const TurningAngle<S>& turning) {
    return S(2) * turning.half_tangent;
  }
  template <class S>
  static S value(const TurningAngle<S>& turning, const S& rest) {
    const S difference = S(2) * turning.half_tangent - rest;
    return S(0.5) * difference * difference;
  }
  template <class S>
  static S first(const TurningAngle<S>& turning, const S& rest) {
    const S& t = turning.half_tangent;
    return (S(2) * t - rest) * (S(1) + t * t);
  }
  template <class S>
  static S second(const TurningAngle<S>& turning, const S& rest) {
    const S& t = turning.half_tangent;
    const S slope = S(1) + t * t;
    return slope * (slope + (S(2) * t - rest) * t);
  }
};

}  // namespace

void register_tan_bending(Registry& registry);
void register_tan_bending(Registry& registry) {
  register_energy<AngleBending<TangentLaw>>(
      registry, "tan_bending",
      {"bending by the curvature of discrete elastic rods, which folds only at infinite energy",
       "k/2 (kappa - kappa0)^2, kappa = 2 tan((pi - theta)/2), k = EI / lbar",
       "math.md, section 2; Discrete Elastic Rods, SIGGRAPH 2008"});
}

}  // namespace ringlet
