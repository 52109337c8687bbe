#include "plugins/render/camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace ringlet {
namespace {

/// The part of the picture that nothing is in, on each side.
constexpr double margin = 0.04;

Eigen::Vector3d any_side(const Eigen::Vector3d& back) {
  int axis = 0;
  back.cwiseAbs().minCoeff(&axis);
  return Eigen::Vector3d::Unit(axis).cross(back).normalized();
}

}  // namespace

Camera::Camera(const Eigen::Vector3d& position, const Eigen::Vector3d& target,
               const Eigen::Vector3d& up, double field_of_view, int width, int height)
    : position_(position), width_(width), height_(height) {
  back_ = (position - target).stableNormalized();
  right_ = up.cross(back_);
  right_ =
      right_.norm() > 1e-6 * up.norm() ? Eigen::Vector3d(right_.normalized()) : any_side(back_);
  up_ = back_.cross(right_);
  tangent_.y() = std::tan(0.5 * field_of_view);
  tangent_.x() = tangent_.y() * width / height;
}

Eigen::Vector3d Camera::direction_through(double x, double y) const {
  const double across = (2 * x / width_ - 1) * tangent_.x();
  const double upward = (1 - 2 * y / height_) * tangent_.y();
  return (across * right_ + upward * up_ - back_).normalized();
}

std::optional<Eigen::Vector2d> Camera::project(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d offset = point - position_;
  const double depth = -offset.dot(back_);
  if (!(depth > 0)) return {};
  const double x = offset.dot(right_) / (depth * tangent_.x());
  const double y = offset.dot(up_) / (depth * tangent_.y());
  return Eigen::Vector2d(0.5 * width_ * (1 + x), 0.5 * height_ * (1 - y));
}

Framing::Framing(const Eigen::Vector3d& direction, const Eigen::Vector3d& up, double field_of_view,
                 int width, int height)
    : view_(Eigen::Vector3d::Zero(), -direction, up, field_of_view, width, height),
      tangent_((1 - 2 * margin) * view_.tangent_) {}

// With camera axes x, y (picture) and z (back), a point p is between the left and the right edge
// of what a camera at c sees if |px - cx| <= t (cz - pz): two bounds that are linear in c.
void Framing::add(const Eigen::Vector3d& centre, double radius) {
  const double z = centre.dot(view_.back_);
  const Eigen::Vector2d along{centre.dot(view_.right_), centre.dot(view_.up_)};
  for (int axis = 0; axis < 2; ++axis) {
    const double t = tangent_[axis];
    const double reach = t * z + radius * std::sqrt(1 + t * t);
    beyond_[axis] = std::max(beyond_[axis], along[axis] + reach);
    below_[axis] = std::max(below_[axis], -along[axis] + reach);
  }
  nearest_ = std::max(nearest_, z + radius);
}

Camera Framing::camera() const {
  Camera camera = view_;
  if (nearest_ == none) {
    camera.position_ = view_.back_;
    return camera;
  }
  const Eigen::Vector2d middle = 0.5 * (beyond_ - below_);
  const double behind = (0.5 * (beyond_ + below_)).cwiseQuotient(tangent_).maxCoeff();
  // A single point without a radius is seen from a distance, too.
  const double distance = std::max(behind - nearest_, 1e-3);
  camera.position_ =
      middle.x() * view_.right_ + middle.y() * view_.up_ + (nearest_ + distance) * view_.back_;
  return camera;
}

}  // namespace ringlet
