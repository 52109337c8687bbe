// Bending by the change of the unit tangent along the strand (math.md, section 2):
//
//     E = k/2 (s - s0)^2,  s = |t1 + t0| = 2 sin(phi/2),  phi = pi - theta,  k = EI / lbar
//
// t0 and t1 both leave the middle vertex. s is as good a curvature as the angle itself for small
// phi, and has no pole; what it resists least is a fold.

#include "energies/angle_bending.h"

namespace ringlet {

namespace {

// With cosine = 1 / sqrt(1 + tan^2(phi/2)): ds/dphi = cosine, d2s/dphi2 = -s/4.
struct SineLaw {
  template <class S>
  static S cosine(const TurningAngle<S>& turning) {
    return S(1) / sqrt(S(1) + turning.half_tangent * turning.half_tangent);
  }
  template <class S>
  static S measure(const TurningAngle<S>& turning) {
    return S(2) * turning.half_tangent * cosine(turning);
  }
  template <class S>
  static S rest(const TurningAngle<S>& turning) {
    return measure(turning);
  }
  template <class S>
  static S value(const TurningAngle<S>& turning, const S& rest) {
    const S difference = measure(turning) - rest;
    return S(0.5) * difference * difference;
  }
  template <class S>
  static S first(const TurningAngle<S>& turning, const S& rest) {
    return (measure(turning) - rest) * cosine(turning);
  }
  template <class S>
  static S second(const TurningAngle<S>& turning, const S& rest) {
    const S s = measure(turning), slope = cosine(turning);
    return slope * slope - S(0.25) * (s - rest) * s;
  }
};

}  // namespace

void register_sin_bending(Registry& registry);
void register_sin_bending(Registry& registry) {
  register_energy<AngleBending<SineLaw>>(
      registry, "sin_bending",
      {"bending by the change of the unit tangent, which has no pole at a fold",
       "k/2 (s - s0)^2, s = 2 sin((pi - theta)/2), k = EI / lbar", "math.md, section 2"});
}

}  // namespace ringlet
