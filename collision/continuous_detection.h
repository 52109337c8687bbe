#pragma once

#include "collision/swept_pairs.h"

namespace ringlet {

/// What comes nearer than this part of its first distance has passed through.
inline constexpr double vanishing = 1e-6;

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

 private:
  const ContactRule& rule_;
  SweptPairs swept_pairs_;
};

/// The part of the way along which none of some pairs comes nearer than a part of its first
/// distance. Pairs without a thickness, which cross at rest, may pass through each other.
double free_part_of_pairs(std::span<const EdgePair> pairs, std::span<const double> thickness,
                          std::span<const Eigen::Vector3d> from,
                          std::span<const Eigen::Vector3d> to, double kept_part);

}  // namespace ringlet
