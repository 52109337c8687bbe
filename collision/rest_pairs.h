#pragma once

#include <span>
#include <vector>

#include "core/contact_detector.h"

namespace ringlet {

/// Pairs of edges that are near each other in the rest shape: those do not push while they are no
/// nearer than at rest, else strands made to lie together would burst apart.
class RestPairs {
 public:
  /// Asks the detector, bound to these strands, for the pairs nearer at rest than a thickness, m.
  RestPairs(const Strands& strands, ContactDetector& detector, double thickness);

  /// Of some pairs, sorted as a detector sorts them: replaces the thickness of each that is near at
  /// rest by its distance there. That is short by a millionth, so that rounding makes no contacts
  /// of pairs at rest.
  void limit(std::span<const EdgePair> pairs, std::span<double> thickness) const;

 private:
  std::vector<EdgePair> pairs_;    // sorted
  std::vector<double> thickness_;  // of each
};

}  // namespace ringlet
