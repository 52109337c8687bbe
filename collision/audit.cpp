#include "collision/audit.h"

namespace ringlet {

void Audit::end_step(std::span<const Eigen::Vector3d> positions, ContactReport& report) {
  report.depth = colliders_.deepest(positions);
  if (continuous_ == nullptr) return;
  bring_to(positions, start_);
  report.crossings = continuous_->count_crossings(start_, positions);
}

}  // namespace ringlet
