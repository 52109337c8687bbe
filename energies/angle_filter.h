#pragma once

// Any energy Psi of an angle theta between two vectors, per unit stiffness (math.md, section 2).
//
// Each vector t_i of length l_i has its unit tangent and the unit vector b_i normal to it in the
// plane of the two, such that dtheta/dt_0 = b_0 / l_0 and dtheta/dt_1 = -b_1 / l_1. With g =
// Psi'(theta) and h = Psi''(theta) the Hessian in that plane has four eigenpairs, two and two of
// opposite sign; with r = sqrt(h^2 + g^2):
//
//     h +- r    (g t0 - (h +- r) b0, g t1 + (h +- r) b1)
//     +-|g|     (t0 -+ s b0, -t1 -+ s b1),  s the sign of g

#include <algorithm>

#include "core/element.h"

namespace ringlet {

/// Square of the length, m^2, at or below which an edge of an element has collapsed: it has no
/// direction, hence the element no angle. Relative to the shortest rest length of the element; the
/// absolute bound, far below any strand, keeps products of squares from underflow.
inline double collapsed_squared_length(double shortest_rest_length) {
  const double length = std::max(1e-8 * shortest_rest_length, 1e-20);
  return length * length;
}

/// Positive and negative part of the 2x2 matrix [[0, g], [g, 2h]], given the square of g:
/// weight (g, positive)(g, positive)^T - weight (g, negative)(g, negative)^T.
template <class S>
struct SplitPair {
  S weight, positive, negative;
};

template <class S>
SplitPair<S> split_pair(const S& squared_g, const S& h) {
  // Where both vanish so do the vectors; the weight must stay finite, also times a stiffness.
  const S squared = max(S(h * h + squared_g), S(1e-300));
  const S inverse = inverse_sqrt(squared), radius = squared * inverse;
  return {S(0.5) * inverse, h + radius, h - radius};
}

/// Tangents and normals in the plane of an angle, each divided by the length of its vector.
template <class S>
struct AnglePlane {
  Vector3<S> t0, b0, t1, b1;
};

/// The in-plane Hessian as terms weight (q0, q1)(q0, q1)^T over the two vectors of an angle:
/// see(number, weight, q0, q1) with its positive part, two terms, then, of four, its negative part.
/// (An array of terms to return would be copied through memory.)
template <std::size_t N, class S, class See>
[[gnu::always_inline]] inline void for_in_plane_terms(const AnglePlane<S>& plane, const S& g,
                                                      const S& h, const See& see) {
  static_assert(N == 2 || N == 4);
  const auto& [t0, b0, t1, b1] = plane;
  const SplitPair<S> split = split_pair(S(g * g), h);
  const S sign = copysign(S(1), g);
  const S half_weight = S(0.5) * split.weight, quarter_g = S(0.25) * abs(g);
  const auto& [weight, positive, negative] = split;
  see(0, half_weight, g * t0 - positive * b0, g * t1 + positive * b1);
  see(1, quarter_g, t0 - sign * b0, -t1 - sign * b1);
  if constexpr (N == 4) {
    see(2, -half_weight, g * t0 - negative * b0, g * t1 + negative * b1);
    see(3, -quarter_g, t0 + sign * b0, sign * b1 - t1);
  }
}

}  // namespace ringlet
