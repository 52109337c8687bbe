#pragma once

#include <vector>

#include "core/contact_detector.h"

namespace ringlet {

/// Which pairs of edges can be contacts, however near they are. Not those of one strand with less
/// than a minimum of arc between their nearest ends, nor those that share a vertex; nor those of
/// which all four vertices are pinned.
class ContactRule {
 public:
  /// arc_distance: the minimum, m, along the rest shape.
  ContactRule(const Strands& strands, double arc_distance);

  /// is_free: of each vertex.
  void set_free(const std::vector<bool>& is_free);
  bool allows(EdgePair pair) const {
    if (is_pinned_[pair.first] && is_pinned_[pair.second]) return false;
    if (strands_.strand_of(pair.first) != strands_.strand_of(pair.second)) return true;
    return pair.second - pair.first > 1 &&
           arc_[pair.second] - arc_[pair.first + 1] >= arc_distance_;
  }

 private:
  const Strands& strands_;
  double arc_distance_;
  std::vector<double> arc_;      // of each vertex, from its root
  std::vector<char> is_pinned_;  // of each edge: both of its vertices are
};

}  // namespace ringlet
