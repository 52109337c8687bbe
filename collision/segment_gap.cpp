#include "collision/segment_gap.h"

#include <limits>

#include "collision/segment_distance.h"

namespace ringlet {
namespace {

constexpr double preference = 0.01;  // e, for the middle of the segments
/// Each makes the place of the minimum more exact by a factor of about e.
constexpr int corrections = 2;

template <class S>
S gap_growth(const SegmentProximity<S>& at) {
  const S s = at.s - S(0.5), t = at.t - S(0.5);
  return S(1) + S(preference) * (s * s + t * t);
}

template <class S>
struct Gap {
  S distance;
  std::array<S, 4> weights;
  Vector3<S> normal;  ///< 0 where the segments cross
};

// At the minimum, grad |p - q|^2 + m grad ((s - 1/2)^2 + (t - 1/2)^2) = 0 with
// m = e |p - q|^2 / gap_growth: for a fixed m that of a quadratic function.
template <class S>
Gap<S> measure(const Vector3<S>& p0, const Vector3<S>& p1, const Vector3<S>& q0,
               const Vector3<S>& q1, double reach) {
  SegmentProximity<S> at = closest_points(p0, p1, q0, q1);
  if (!any(at.squared_distance < S(reach * reach))) return {sqrt(at.squared_distance), {}, {}};
  for (int i = 0; i < corrections; ++i) {
    at = closest_points(p0, p1, q0, q1, S(S(preference) * at.squared_distance / gap_growth(at)));
  }
  const S stretch = sqrt(gap_growth(at)), apart = sqrt(at.squared_distance);
  const Vector3<S> difference = (p0 - q0) + at.s * (p1 - p0) - at.t * (q1 - q0);
  return {stretch * apart,
          {stretch * (S(1) - at.s), stretch * at.s, stretch * (at.t - S(1)), -stretch * at.t},
          S(S(1) / select(apart > S(0), apart, S(1))) * difference};
}

// A unit vector normal to two edges that meet; of either edge alone, if the other has no length or
// the same direction; of nothing, if both have no length.
Vector3<double> crossing_normal(const Vector3<double>& d, const Vector3<double>& e) {
  const Vector3<double> across = cross(d, e);
  const double length = norm(across), scale = norm(d) * norm(e);
  if (length > 1e-12 * scale) return 1 / length * across;
  if (squared_norm(d) > 0) return any_normal(d);
  if (squared_norm(e) > 0) return any_normal(e);
  return {1, 0, 0};
}

}  // namespace

SegmentGap segment_gap(const std::array<Eigen::Vector3d, 4>& vertices) {
  const Vector3<double> p0 = from_eigen(vertices[0]), p1 = from_eigen(vertices[1]);
  const Vector3<double> q0 = from_eigen(vertices[2]), q1 = from_eigen(vertices[3]);
  const Gap<double> gap = measure(p0, p1, q0, q1, std::numeric_limits<double>::infinity());
  const bool cross = gap.distance == 0;
  return {gap.distance, gap.weights,
          to_eigen(cross ? crossing_normal(p1 - p0, q1 - q0) : gap.normal)};
}

// Packs handed over to functions in memory would cost more than the sums, hence flatten.
[[gnu::flatten]] SegmentGaps::SegmentGaps(std::span<const EdgePair> pairs, const VertexField& x,
                                          double reach) {
  const int last = static_cast<int>(pairs.size()) - 1;
  const auto vertices = [&](auto member, int next) {
    Vector3<Pack> v;
    for (int lane = 0; lane < lane_count; ++lane) {
      const Eigen::Vector3d at = x.get(pairs[std::min(lane, last)].*member + next);
      v.x[lane] = at.x();
      v.y[lane] = at.y();
      v.z[lane] = at.z();
    }
    return v;
  };
  const Gap<Pack> gap =
      measure(vertices(&EdgePair::first, 0), vertices(&EdgePair::first, 1),
              vertices(&EdgePair::second, 0), vertices(&EdgePair::second, 1), reach);
  distance_ = gap.distance;
  weights_ = gap.weights;
  normal_ = gap.normal;
}

SegmentGap SegmentGaps::of(int pair) const {
  SegmentGap gap{distance_[pair], {}, {normal_.x[pair], normal_.y[pair], normal_.z[pair]}};
  for (int i = 0; i < 4; ++i) gap.weights[i] = weights_[i][pair];
  return gap;
}

}  // namespace ringlet
