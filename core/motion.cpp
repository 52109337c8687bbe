#include "core/motion.h"

#include "core/registry.h"

namespace ringlet {

void Motions::add(const std::string& name, std::vector<std::unique_ptr<Motion>> parts) {
  parts_[name] = std::move(parts);
}

Eigen::Isometry3d Motions::at(const std::string& name, double time) const {
  Eigen::Isometry3d placement = Eigen::Isometry3d::Identity();
  if (name.empty()) return placement;
  const auto found = parts_.find(name);
  if (found == parts_.end()) throw Error("there is no motion named '" + name + "'");
  for (const auto& part : found->second) {
    placement = naming(*part, [&] { return part->at(time); }) * placement;
  }
  return placement;
}

const Eigen::Isometry3d& Displacements::by(const std::string& name) {
  if (last_ != known_.end() && last_->first == name) return last_->second;
  last_ = known_.find(name);
  if (last_ == known_.end()) {
    last_ = known_.emplace(name, motions_.at(name, to_) * motions_.at(name, from_).inverse()).first;
  }
  return last_->second;
}

}  // namespace ringlet
