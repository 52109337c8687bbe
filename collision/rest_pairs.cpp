#include "collision/rest_pairs.h"

#include <cmath>

#include "collision/segment_distance.h"
#include "core/registry.h"

namespace ringlet {
namespace {

/// What is nearer at rest than this part of the thickness crosses there.
constexpr double crossing = 1e-6;

}  // namespace

RestPairs::RestPairs(const Strands& strands, ContactDetector& detector, double thickness,
                     double slack) {
  std::vector<Eigen::Vector3d> rest(strands.vertex_count());
  for (int v = 0; v < strands.vertex_count(); ++v) rest[v] = strands.rest_position(v);
  naming(detector, [&] { detector.find(rest, thickness, pairs_); });
  const auto at = [&](int v) { return from_eigen(rest[v]); };
  for (const auto [a, b] : pairs_) {
    const double distance =
        std::sqrt(closest_points(at(a), at(a + 1), at(b), at(b + 1)).squared_distance);
    thickness_.push_back(distance > crossing * thickness ? (1 - slack) * distance : 0);
  }
}

void RestPairs::limit(std::span<const EdgePair> pairs, std::span<double> thickness) const {
  std::size_t r = 0;
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    while (r < pairs_.size() && pairs_[r] < pairs[p]) ++r;
    if (r < pairs_.size() && pairs_[r] == pairs[p]) thickness[p] = thickness_[r];
  }
}

}  // namespace ringlet
