#include "collision/detectors/pair_sieve.h"

#include "collision/segment_distance.h"

namespace ringlet {

// Packs handed over to functions in memory would cost more than the sums, hence flatten.
[[gnu::flatten]] void PairSieve::flush() {
  if (waiting_count_ == 0) return;
  for (int lane = waiting_count_; lane < lane_count; ++lane) waiting_[lane] = waiting_[0];
  const auto vertices = [&](auto member, int next) {
    const auto coordinate = [&](int c) {
      return Pack([&](auto lane) { return positions_[waiting_[lane].*member + next][c]; });
    };
    return Vector3<Pack>{coordinate(0), coordinate(1), coordinate(2)};
  };
  const Vector3<Pack> p0 = vertices(&EdgePair::first, 0), p1 = vertices(&EdgePair::first, 1),
                      q0 = vertices(&EdgePair::second, 0), q1 = vertices(&EdgePair::second, 1);
  const Pack squared_distance = closest_points(p0, p1, q0, q1).squared_distance;
  // The same formula rounds otherwise in lanes; near-parallel edges make most of that. Where this
  // might matter the one function that decides is asked.
  const Pack doubt = 1e-12 * (squared_norm(p1 - p0) + squared_norm(q1 - q0) +
                              squared_norm(q0 - p0) + reach_ * reach_);
  const Mask may_be = squared_distance < reach_ * reach_ + doubt;
  if (any(may_be)) {
    const Mask is_sure = squared_distance < reach_ * reach_ - doubt;
    for (int lane = 0; lane < waiting_count_; ++lane) {
      if (is_sure[lane] || (may_be[lane] && is_nearer(positions_, waiting_[lane], reach_))) {
        kept_.push_back(waiting_[lane]);
      }
    }
  }
  waiting_count_ = 0;
}

}  // namespace ringlet
