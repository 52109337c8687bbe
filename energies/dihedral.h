#pragma once

// A dihedral of four vertices and its torsion (math.md, section 1).

#include "core/angles.h"
#include "core/element.h"

namespace ringlet {

/// The edges of a dihedral, their parts normal to the middle one, and its torsion. Where an edge
/// has collapsed, a benign dihedral without stiffness stands in for it.
template <class S>
struct Dihedral {
  Vector3<S> e0, e1, e2;
  S n0, n1, n2;  ///< squared lengths
  S stiffness;   ///< 0 where the dihedral has collapsed
  S inverse_length;
  Vector3<S> d;     ///< e1 / |e1|
  S a, c;           ///< e0 = u + a e1, e2 = v + c e1
  Vector3<S> u, v;  ///< normal to e1
  S uu, vv;         ///< squared lengths, never 0
  S sine, cosine;   ///< of tau, times |u||v|
  S torsion;        ///< tau

  [[gnu::always_inline]] Dihedral(const Stencil<S, 4>& x, const S& given_stiffness,
                                  const S& shortest_squared)
      : e0(x[0] - x[1]),
        e1(x[2] - x[1]),
        e2(x[3] - x[2]),
        n0(squared_norm(e0)),
        n1(squared_norm(e1)),
        n2(squared_norm(e2)),
        stiffness(given_stiffness) {
    const auto collapsed =
        n0 <= shortest_squared || n1 <= shortest_squared || n2 <= shortest_squared;
    if (any(collapsed)) {
      e0 = select(collapsed, Vector3<S>{S(0), S(1), S(0)}, e0);
      e1 = select(collapsed, Vector3<S>{S(1), S(0), S(0)}, e1);
      e2 = select(collapsed, Vector3<S>{S(0), S(0), S(1)}, e2);
      n0 = select(collapsed, S(1), n0);
      n1 = select(collapsed, S(1), n1);
      n2 = select(collapsed, S(1), n2);
      stiffness = select(collapsed, S(0), stiffness);
    }
    inverse_length = inverse_sqrt(n1);
    d = inverse_length * e1;
    a = dot(e0, d) * inverse_length;
    c = dot(e2, d) * inverse_length;
    u = e0 - a * e1;
    v = e2 - c * e1;
    // Rounding is all that is left of u below this; its square must have an inverse.
    constexpr double rounding = 1e-16;
    uu = max(squared_norm(u), S(rounding * rounding) * n0);
    vv = max(squared_norm(v), S(rounding * rounding) * n2);
    sine = dot(d, cross(u, v));
    cosine = dot(u, v);
    torsion = atan2(sine, cosine);
  }
};

}  // namespace ringlet
