#pragma once

#include <span>

#include "core/contact_detector.h"
#include "core/vector3.h"

namespace ringlet {

/// Where two segments come nearest to each other: at p0 + s (p1 - p0) and q0 + t (q1 - q0).
template <class S>
struct SegmentProximity {
  S s, t;  ///< in [0, 1]
  S squared_distance;
};

/// The closest points of two segments, end points included, for any scalar of a kernel. With
/// d = p1 - p0, e = q1 - q0, r = q0 - p0, n = d x e, and [.] a clamp to [0, 1]:
///
///     s = [(r x e) . n / |n|^2],  t = [(s d - r) . e / |e|^2],  s = [(r + t e) . d / |d|^2]
///
/// that is, the closest point of the two lines, then twice the best place on one segment for that
/// on the other (Lumelsky, "On fast computation of distance between line segments", 1985). Where
/// the segments are parallel or one has no length, any first s serves; here it is 0.
template <class S>
SegmentProximity<S> closest_points(const Vector3<S>& p0, const Vector3<S>& p1, const Vector3<S>& q0,
                                   const Vector3<S>& q1) {
  const S zero(0), one(1);
  // Always inline: packs handed over in memory cost more than the sums.
  const auto divide = [&](const S& a, const S& b) __attribute__((always_inline)) {
    return S(a / select(b > zero, b, one));
  };
  const auto clamp = [&](const S& a) __attribute__((always_inline)) {
    return S(min(max(a, zero), one));
  };
  const Vector3<S> d = p1 - p0, e = q1 - q0, r = q0 - p0;
  const Vector3<S> n = cross(d, e);
  const S de = dot(d, e);
  S s = clamp(divide(dot(cross(r, e), n), squared_norm(n)));
  const S t = clamp(divide(S(s * de - dot(r, e)), squared_norm(e)));
  s = clamp(divide(S(dot(r, d) + t * de), squared_norm(d)));
  return {s, t, squared_norm(r + t * e - s * d)};
}

/// Whether two edges are nearer to each other than reach. Detectors, which look for such pairs each
/// in its own way, ask this of what they find: compiled once, it gives all of them the same answer,
/// to the last bit, where the distance is the reach.
bool is_nearer(std::span<const Eigen::Vector3d> positions, const EdgePair& pair, double reach);

}  // namespace ringlet
