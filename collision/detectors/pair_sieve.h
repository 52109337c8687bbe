#pragma once

#include <span>
#include <vector>

#include "core/contact_detector.h"
#include "core/lanes.h"

namespace ringlet {

/// Keeps those of some pairs of edges that are nearer to each other than a reach: what is_nearer()
/// says of them, but measured side by side in lanes.
class PairSieve {
 public:
  /// Kept pairs are appended to `kept`. The positions outlive the sieve.
  PairSieve(std::span<const Eigen::Vector3d> positions, double reach, std::vector<EdgePair>& kept)
      : positions_(positions), reach_(reach), kept_(kept) {}

  void add(const EdgePair& pair) {
    waiting_[waiting_count_++] = pair;
    if (waiting_count_ == lane_count) flush();
  }
  /// To be called after the last add().
  void flush();

 private:
  std::span<const Eigen::Vector3d> positions_;
  double reach_;
  std::vector<EdgePair>& kept_;
  std::array<EdgePair, lane_count> waiting_;
  int waiting_count_ = 0;
};

}  // namespace ringlet
