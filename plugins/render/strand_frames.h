#pragma once

#include <Eigen/Core>
#include <vector>

namespace ringlet {

/// Unit vectors across a strand at each of its vertices. From vertex to vertex they turn with the
/// tangent, by the smallest rotation there is, and not around it.
struct StrandFrames {
  std::vector<Eigen::Vector3d> first, second;
};

/// Of a strand of one or more vertices. Edges of length zero take the direction of those before.
StrandFrames parallel_frames(const Eigen::Ref<const Eigen::Matrix3Xd>& vertices);

}  // namespace ringlet
