#pragma once

#include <span>
#include <vector>

#include "core/bytes.h"
#include "core/contact_detector.h"

namespace ringlet {

/// Pairs of edges that are near each other in the rest shape: those do not push there, else strands
/// made to lie together would burst apart, nor where they are only a little nearer than at rest.
class RestPairs {
 public:
  /// Asks the detector, bound to these strands, for the pairs nearer at rest than a thickness, m.
  /// slack: the part of that distance by which they may come nearer to each other.
  RestPairs(const Strands& strands, ContactDetector& detector, double thickness, double slack);

  /// Of some pairs, sorted as a detector sorts them: replaces the thickness of each that is near at
  /// rest by its distance there without the slack; by 0 if they cross at rest, nearer than a
  /// millionth of the thickness.
  void limit(std::span<const EdgePair> pairs, std::span<double> thickness) const;

  std::size_t bytes() const { return bytes_of(pairs_) + bytes_of(thickness_); }

 private:
  std::vector<EdgePair> pairs_;    // sorted
  std::vector<double> thickness_;  // of each
};

}  // namespace ringlet
