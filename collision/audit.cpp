#include "collision/audit.h"

#include <algorithm>
#include <iterator>

namespace ringlet {

void Audit::begin_step(std::span<const Eigen::Vector3d> positions) {
  positions_.assign(positions.begin(), positions.end());
  crossings_.clear();
  is_first_way_ = true;
}

void Audit::follow(std::span<const Eigen::Vector3d> positions) {
  if (std::exchange(is_first_way_, false)) bring_to(positions, positions_);
  if (continuous_ != nullptr) {
    const std::vector<EdgePair> passed = continuous_->find_crossings(positions_, positions);
    std::vector<EdgePair> odd;
    std::set_symmetric_difference(crossings_.begin(), crossings_.end(), passed.begin(),
                                  passed.end(), std::back_inserter(odd));
    crossings_ = std::move(odd);
  }
  positions_.assign(positions.begin(), positions.end());
}

void Audit::end_step(ContactReport& report) const {
  report.depth = colliders_.deepest(positions_);
  if (continuous_ != nullptr) report.crossings = static_cast<double>(crossings_.size());
}

}  // namespace ringlet
