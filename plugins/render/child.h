#pragma once

#include "plugins/render/guide.h"

namespace ringlet {

/// How hairs are interpolated around each strand.
struct ChildParameters {
  int count = 0;         ///< around each strand
  double radius = 4e-5;  ///< of a child, m
  double spread = 1;     ///< radius of the bundle, in radii of the strand
  double frizz = 0;      ///< in [0, 1]: the part of its offset that wanders along a child
  double strays = 0;     ///< the part of the children that leave the bundle
};

/// One of the hairs around a strand. It keeps its place across the strand, in a frame without
/// twist, but for the frizz, and ends a little before the tip. What makes it another than its
/// siblings is drawn by chance, the same for the same strand and number.
class Child {
 public:
  Child(const Guide& guide, int number, const ChildParameters& parameters);

  /// Its place in the disc of radius 1, but for the frizz.
  const Eigen::Vector2d& place() const { return place_; }
  /// Where its tip is: 2.5 is in the middle between the strand's third and fourth vertex.
  double end() const { return end_; }
  /// What it would be if it did not end: as many points as the strand has vertices: visit(i,
  /// point).
  template <class Visit>
  void for_each_point(const Guide& guide, const Visit& visit) {
    for (int i = 0; i < guide.count(); ++i, advance()) {
      const Guide::Place at = guide.at(i);
      const Eigen::Vector2d offset = spread_ * at.radius * offset_now();
      visit(i, at.centre + offset.x() * at.first + offset.y() * at.second);
    }
  }

 private:
  static constexpr int common_waves = 4, waves = 6;
  void advance();
  Eigen::Vector2d offset_now() const;

  Eigen::Vector2d place_;
  double end_;
  double spread_, frizz_;
  // Sines along the hair: where each is now, and by what it turns from vertex to vertex.
  Eigen::Vector2d now_[waves], turn_[waves];
};

}  // namespace ringlet
