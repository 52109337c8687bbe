#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/vector3.h"

namespace ringlet {

/// Positions of vertices with one array a coordinate, so that consecutive vertices, and with these
/// consecutive edges, are read side by side in lanes.
class CoordinateArrays {
 public:
  void set(std::span<const Eigen::Vector3d> positions);

  Vector3<double> get(int vertex) const {
    return {arrays_[0][vertex], arrays_[1][vertex], arrays_[2][vertex]};
  }
  /// The vertices from the first on, one a lane; behind the last of all, anything finite.
  Vector3<Pack> lanes(int first) const {
    return {load(arrays_[0], first), load(arrays_[1], first), load(arrays_[2], first)};
  }

 private:
  static Pack load(const std::vector<double>& array, int first) {
    return Pack(&array[first], std::experimental::element_aligned);
  }
  std::array<std::vector<double>, 3> arrays_;
};

}  // namespace ringlet
