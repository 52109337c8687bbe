#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>

namespace ringlet {

/// A pinhole camera. Pixel (x, y) covers [x, x + 1) x [y, y + 1); y runs down.
class Camera {
 public:
  /// Looks from a position to a target, or, where `up` is along this way, with any side up. The
  /// field of view, rad, is the angle between the lower and the upper edge.
  Camera(const Eigen::Vector3d& position, const Eigen::Vector3d& target, const Eigen::Vector3d& up,
         double field_of_view, int width, int height);

  const Eigen::Vector3d& position() const { return position_; }
  int width() const { return width_; }
  int height() const { return height_; }
  /// The way of the ray through a point of the picture, of length 1.
  Eigen::Vector3d direction_through(double x, double y) const;
  /// Where a point is in the picture; nothing for one that is not in front of the camera.
  std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& point) const;

 private:
  friend class Framing;
  Eigen::Vector3d position_;
  Eigen::Vector3d right_, up_, back_;
  Eigen::Vector2d tangent_;  // of half the angles of view
  int width_, height_;
};

/// Finds the camera that looks along a direction and is as near as it can be to see all balls that
/// were added.
class Framing {
 public:
  /// `direction` points from what is seen to the camera.
  Framing(const Eigen::Vector3d& direction, const Eigen::Vector3d& up, double field_of_view,
          int width, int height);

  void add(const Eigen::Vector3d& centre, double radius);
  /// With a small margin around what was added. Without anything added it looks at the origin.
  Camera camera() const;

 private:
  static constexpr double none = -std::numeric_limits<double>::infinity();
  Camera view_;  // with the directions wanted, but at the origin
  Eigen::Vector2d tangent_;
  // The largest a + t z and -a + t z, for the picture's axes a = x, y.
  Eigen::Vector2d beyond_{none, none}, below_{none, none};
  double nearest_ = none;
};

}  // namespace ringlet
