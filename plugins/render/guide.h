#pragma once

#include <cstdint>
#include <vector>

#include "plugins/render/strand_frames.h"
#include "plugins/render/strand_shapes.h"

namespace ringlet {

/// A strand that hairs are interpolated around.
class Guide {
 public:
  Guide(const StrandShapes& strands, int strand, int first_vertex);

  int strand() const { return strand_; }
  int count() const { return count_; }  ///< of vertices
  double mean_radius() const { return mean_radius_; }
  double mean_edge() const { return mean_edge_; }  ///< m

  struct Place {
    Eigen::Vector3d centre;         ///< on the curve that the strand itself is drawn as
    Eigen::Vector3d first, second;  ///< across it
    double radius;
  };
  /// Between vertices, too: 2.5 is in the middle between the third and the fourth.
  Place at(double t) const;

 private:
  Eigen::Vector3d curve_at(int i, int j, double u) const;

  int strand_, count_;
  Eigen::Ref<const Eigen::Matrix3Xd> vertices_;
  const double* radii_;
  StrandFrames frames_;
  double mean_radius_, mean_edge_;
};

}  // namespace ringlet
