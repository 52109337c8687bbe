#pragma once

#include "collision/swept_pairs.h"

namespace ringlet {

/// Continuous collision detection between strands: all vertices move along straight lines from some
/// positions to others.
class ContinuousDetection {
 public:
  /// The arguments outlive this.
  ContinuousDetection(const Strands& strands, const ContactRule& rule)
      : rule_(rule), swept_pairs_(strands) {}

  /// Every allowed pair that comes nearer than reach, m, on the way, and others; sorted.
  std::vector<EdgePair> find(std::span<const Eigen::Vector3d> from,
                             std::span<const Eigen::Vector3d> to, double reach) {
    return swept_pairs_.find(from, to, reach, rule_);
  }
  /// The allowed pairs that pass through each other on the way; sorted.
  std::vector<EdgePair> find_crossings(std::span<const Eigen::Vector3d> from,
                                       std::span<const Eigen::Vector3d> to);

  std::size_t bytes() const { return swept_pairs_.bytes(); }

 private:
  const ContactRule& rule_;
  SweptPairs swept_pairs_;
};

/// The part of the way along which something is left of the gap of each of some pairs: a part of
/// its first distance, or of its thickness if that is less. Pairs without a thickness, which cross
/// at rest, may pass through each other.
double free_part_of_pairs(std::span<const EdgePair> pairs, std::span<const double> thickness,
                          std::span<const Eigen::Vector3d> from,
                          std::span<const Eigen::Vector3d> to, double kept_part);

}  // namespace ringlet
