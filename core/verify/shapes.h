#pragma once

#include <random>
#include <string>
#include <vector>

#include "core/verify/probe.h"

namespace ringlet {

/// Kinds of strands that random points alone would never show: what is special about the first
/// vertices.
enum class Shape {
  generic,
  nearly_straight,
  nearly_folded,
  nearly_cis,    ///< torsion 0
  nearly_trans,  ///< torsion pi
  straight_end
};
inline constexpr Shape all_shapes[] = {Shape::generic,       Shape::nearly_straight,
                                       Shape::nearly_folded, Shape::nearly_cis,
                                       Shape::nearly_trans,  Shape::straight_end};

const char* shape_name(Shape shape);

/// A strand with edges of 0.5 to 2 m, in a random place; `nearly` is the angle off the special
/// shape.
Points random_strand(std::mt19937_64& random, int vertices, Shape shape, double nearly = 1e-3);

/// Coordinates in [-1, 1].
Points random_points(std::mt19937_64& random, int count);
Eigen::Matrix3d random_rotation(std::mt19937_64& random);

struct NamedShape {
  std::string name;
  Points x;
};

/// Straight, folded, planar, parallel and collapsed strands of at least as many vertices.
std::vector<NamedShape> singular_shapes(int vertices);
/// Those, the special shapes approached down to 1e-18, and a generic strand of every size from
/// 1e-300 to 1e30 m.
std::vector<NamedShape> degenerate_shapes(std::mt19937_64& random, int vertices);

}  // namespace ringlet
