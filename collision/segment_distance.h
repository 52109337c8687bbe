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
///
/// With a pull m, m^2, to the middle of the segments, what is least is
/// |p(s) - q(t)|^2 + m ((s - 1/2)^2 + (t - 1/2)^2), at one place only. All is as before, with |d|^2
/// + m, |e|^2 + m, and m/2 more for either equation's right side.
template <class S>
SegmentProximity<S> closest_points(const Vector3<S>& p0, const Vector3<S>& p1, const Vector3<S>& q0,
                                   const Vector3<S>& q1, const S& pull = S(0)) {
  const S zero(0), one(1), half_pull = S(0.5) * pull;
  // Always inline: packs handed over in memory cost more than the sums.
  const auto divide = [&](const S& a, const S& b) __attribute__((always_inline)) {
    return S(a / select(b > zero, b, one));
  };
  const auto clamp = [&](const S& a) __attribute__((always_inline)) {
    return S(min(max(a, zero), one));
  };
  const Vector3<S> d = p1 - p0, e = q1 - q0, r = q0 - p0;
  const Vector3<S> n = cross(d, e);
  const S de = dot(d, e), rd = dot(r, d), re = dot(r, e);
  const S dd = squared_norm(d) + pull, ee = squared_norm(e) + pull;
  S s = clamp(divide(S(dot(cross(r, e), n) + pull * rd + half_pull * (ee + de)),
                     S(squared_norm(n) + pull * (dd + ee - pull))));
  const S t = clamp(divide(S(s * de - re + half_pull), ee));
  s = clamp(divide(S(rd + t * de + half_pull), dd));
  return {s, t, squared_norm(r + t * e - s * d)};
}

/// Whether two edges are nearer to each other than reach. Detectors, which look for such pairs each
/// in its own way, ask this of what they find: compiled once, it gives all of them the same answer,
/// to the last bit, where the distance is the reach.
bool is_nearer(std::span<const Eigen::Vector3d> positions, const EdgePair& pair, double reach);

}  // namespace ringlet
