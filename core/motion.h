#pragma once

#include <Eigen/Geometry>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/named.h"

namespace ringlet {

/// A prescribed rigid motion: the placement at time t of what is at rest at time 0.
class Motion : public Named {
 public:
  virtual ~Motion() = default;
  virtual Eigen::Isometry3d at(double time) const = 0;
};

/// The named motions of a scene. A named motion is a list of parts; the first is applied first.
class Motions {
 public:
  void add(const std::string& name, std::vector<std::unique_ptr<Motion>> parts);
  /// Placement at a time. The empty name is rest. Throws Error for an unknown name.
  Eigen::Isometry3d at(const std::string& name, double time) const;

 private:
  std::map<std::string, std::vector<std::unique_ptr<Motion>>> parts_;
};

}  // namespace ringlet
