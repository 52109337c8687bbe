#include "collision/contact_rule.h"

namespace ringlet {

ContactRule::ContactRule(const Strands& strands, double arc_distance)
    : strands_(strands),
      arc_distance_(arc_distance),
      arc_(strands.vertex_count(), 0.0),
      is_pinned_(strands.vertex_count(), 0) {
  for (int strand = 0; strand < strands.count(); ++strand) {
    for (int v = strands.first(strand); v + 1 < strands.first(strand + 1); ++v) {
      arc_[v + 1] = arc_[v] + strands.rest_length(v);
    }
  }
}

void ContactRule::set_free(const std::vector<bool>& is_free) {
  for (int v = 0; v + 1 < strands_.vertex_count(); ++v) {
    is_pinned_[v] = !is_free[v] && !is_free[v + 1] ? 1 : 0;
  }
}

}  // namespace ringlet
