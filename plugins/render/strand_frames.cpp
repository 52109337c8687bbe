#include "plugins/render/strand_frames.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace ringlet {
namespace {

/// Of the chord between a vertex's neighbours, as a Catmull-Rom curve has it.
Eigen::Vector3d tangent_at(const Eigen::Ref<const Eigen::Matrix3Xd>& vertices, Eigen::Index i,
                           const Eigen::Vector3d& otherwise) {
  const Eigen::Index before = std::max<Eigen::Index>(i - 1, 0);
  const Eigen::Index after = std::min(i + 1, vertices.cols() - 1);
  const Eigen::Vector3d chord = vertices.col(after) - vertices.col(before);
  const double length = chord.norm();
  return length > 0 ? Eigen::Vector3d(chord / length) : otherwise;
}

Eigen::Vector3d any_across(const Eigen::Vector3d& tangent) {
  int axis = 0;
  tangent.cwiseAbs().minCoeff(&axis);
  return tangent.cross(Eigen::Vector3d::Unit(axis)).normalized();
}

}  // namespace

StrandFrames parallel_frames(const Eigen::Ref<const Eigen::Matrix3Xd>& vertices) {
  StrandFrames frames;
  Eigen::Vector3d tangent = tangent_at(vertices, 0, Eigen::Vector3d::UnitX());
  Eigen::Vector3d across = any_across(tangent);
  for (Eigen::Index i = 0; i < vertices.cols(); ++i) {
    const Eigen::Vector3d next = tangent_at(vertices, i, tangent);
    across = Eigen::Quaterniond::FromTwoVectors(tangent, next) * across;
    // Rounding must not add up over many vertices.
    across = (across - across.dot(next) * next).normalized();
    tangent = next;
    frames.first.push_back(across);
    frames.second.push_back(tangent.cross(across));
  }
  return frames;
}

}  // namespace ringlet
