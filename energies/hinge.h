#pragma once

// A hinge of three vertices and the angle between its edges, which both leave the middle vertex:
// e0 = x0 - x1, e1 = x2 - x1, theta = atan2(|e0 x e1|, e0 . e1); straight is theta = pi
// (math.md, section 1).

#include "core/angles.h"
#include "core/element.h"
#include "energies/angle_filter.h"

namespace ringlet {

/// The angle phi = pi - theta by which a strand turns at a hinge, in [0, pi]. It stands for theta
/// because it keeps its digits near straight.
template <class S>
struct TurningAngle {
  S radians;
  S half_tangent;  ///< tan(phi/2), at most 1e16: the pole is at a folded hinge
};

/// The same of an angle between two edges.
inline TurningAngle<double> turning_angle(double theta) {
  const double turning = std::numbers::pi - theta;
  return {turning, std::tan(0.5 * turning)};
}

/// Where an edge has collapsed, a benign hinge without stiffness stands in for it.
template <class S>
struct Hinge {
  Vector3<S> e0, e1;
  S n0, n1;                  ///< squared lengths
  S stiffness;               ///< 0 where the hinge has collapsed
  Vector3<S> b;              ///< e0 x e1
  S b_norm, inverse_b_norm;  ///< |b| is never 0
  S e0_dot_e1;
  S lengths, inverse_lengths;  ///< of |e0||e1|

  [[gnu::always_inline]] Hinge(const Stencil<S, 3>& x, const S& given_stiffness,
                               const S& shortest_squared)
      : e0(x[0] - x[1]),
        e1(x[2] - x[1]),
        n0(squared_norm(e0)),
        n1(squared_norm(e1)),
        stiffness(given_stiffness) {
    const auto collapsed = n0 <= shortest_squared || n1 <= shortest_squared;
    if (any(collapsed)) {
      e0 = select(collapsed, Vector3<S>{S(0), S(1), S(0)}, e0);
      e1 = select(collapsed, Vector3<S>{S(1), S(0), S(0)}, e1);
      n0 = select(collapsed, S(1), n0);
      n1 = select(collapsed, S(1), n1);
      stiffness = select(collapsed, S(0), stiffness);
    }
    b = cross(e0, e1);
    e0_dot_e1 = dot(e0, e1);
    const S squared_lengths = n0 * n1;
    inverse_lengths = inverse_sqrt(squared_lengths);
    lengths = squared_lengths * inverse_lengths;
    // A perfectly straight hinge turns by a trifle, so that ratios of its small angles exist.
    const S squared_b = max(squared_norm(b), S(S(1e-200) * squared_lengths));
    inverse_b_norm = inverse_sqrt(squared_b);
    b_norm = squared_b * inverse_b_norm;
  }

  /// The smaller of tan(theta/2) and its inverse; nothing cancels in it.
  [[gnu::always_inline]] S small_half_tangent() const {
    return b_norm / (lengths + abs(e0_dot_e1));
  }
  [[gnu::always_inline]] S large_half_tangent() const {
    return (lengths + abs(e0_dot_e1)) * inverse_b_norm;
  }

  [[gnu::always_inline]] TurningAngle<S> turning() const {
    constexpr double most = 1e16;
    const auto acute = e0_dot_e1 > S(0);
    return {atan2(b_norm, S(-e0_dot_e1)),
            select(acute, min(large_half_tangent(), S(most)), small_half_tangent())};
  }

  /// The unit normal of the hinge; of a straight or folded one, any normal to its edges.
  [[gnu::always_inline]] Vector3<S> normal() const {
    constexpr double rounding = 1e-14;
    const Vector3<S> unit = inverse_b_norm * b;
    const auto flat = b_norm <= rounding * lengths;
    return any(flat) ? select(flat, any_normal(e0), unit) : unit;
  }
};

}  // namespace ringlet
