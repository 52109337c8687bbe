#pragma once

#include <array>

#include "core/vector3.h"

namespace ringlet {

/// The point of a triangle nearest to another point, in barycentric coordinates. A coordinate is
/// exactly zero where the nearest point lies on an edge or a vertex.
template <class S>
struct TriangleProximity {
  std::array<S, 3> weights;
  S squared_distance;
};

/// For any scalar of a kernel. The nearest point lies on one of the edges or is the foot of the
/// perpendicular: with r = p - a, n = ab x ac,
///
///     p ~ a + u ab + v ac,  u = (r x ac) . n / |n|^2,  v = (ab x r) . n / |n|^2
///
/// The triangle must not have zero area.
template <class S>
TriangleProximity<S> closest_point(const Vector3<S>& p, const Vector3<S>& a, const Vector3<S>& b,
                                   const Vector3<S>& c) {
  const S zero(0), one(1);
  const auto on_segment = [&](const Vector3<S>& from, const Vector3<S>& to) {
    const Vector3<S> along = to - from;
    return S(min(max(S(dot(p - from, along) / squared_norm(along)), zero), one));
  };
  const auto squared_distance_at = [&](const Vector3<S>& from, const Vector3<S>& to, const S& s) {
    return squared_norm(p - from - s * (to - from));
  };
  const S ab = on_segment(a, b), bc = on_segment(b, c), ca = on_segment(c, a);
  TriangleProximity<S> best{{S(one - ab), ab, zero}, squared_distance_at(a, b, ab)};
  const auto consider = [&](const std::array<S, 3>& weights, const S& squared_distance,
                            const auto& nearer) {
    for (int i = 0; i < 3; ++i) best.weights[i] = select(nearer, weights[i], best.weights[i]);
    best.squared_distance = select(nearer, squared_distance, best.squared_distance);
  };
  const S distance_bc = squared_distance_at(b, c, bc), distance_ca = squared_distance_at(c, a, ca);
  consider({zero, S(one - bc), bc}, distance_bc, distance_bc < best.squared_distance);
  consider({ca, zero, S(one - ca)}, distance_ca, distance_ca < best.squared_distance);

  const Vector3<S> e = b - a, f = c - a, r = p - a;
  const Vector3<S> n = cross(e, f);
  const S nn = squared_norm(n);
  const S u = dot(cross(r, f), n) / nn, v = dot(cross(e, r), n) / nn;
  const S inside_distance = squared_norm(r - u * e - v * f);
  consider({S(one - u - v), u, v}, inside_distance, u > zero && v > zero && u + v < one);
  return best;
}

}  // namespace ringlet
