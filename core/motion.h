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

/// How far the motions of a scene take what follows them from one time to another.
class Displacements {
 public:
  Displacements(const Motions& motions, double from, double to)
      : motions_(motions), from_(from), to_(to) {}
  Displacements(const Displacements&) = delete;
  Displacements& operator=(const Displacements&) = delete;

  /// By a motion of this name. The result stays where it is.
  const Eigen::Isometry3d& by(const std::string& name);

 private:
  using Known = std::map<std::string, Eigen::Isometry3d>;

  const Motions& motions_;
  double from_, to_;
  Known known_;
  Known::iterator last_ = known_.end();  ///< asked for: most often it is asked for again
};

}  // namespace ringlet
