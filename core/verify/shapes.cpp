#include "core/verify/shapes.h"

#include <spdlog/fmt/fmt.h>

#include <Eigen/Geometry>
#include <numbers>

namespace ringlet {

namespace {

constexpr double pi = std::numbers::pi;

double random_between(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// The first columns, or as many more in a zigzag as are missing.
Points with_vertices(const Points& x, int vertices) {
  if (vertices <= x.cols()) return x.leftCols(vertices);
  Points longer(3, vertices);
  longer.leftCols(x.cols()) = x;
  const double length = std::max((x.rightCols(1) - x.leftCols(1)).norm() / 3, 1e-300);
  for (int v = static_cast<int>(x.cols()); v < vertices; ++v) {
    const Eigen::Vector3d step(0.6, v % 2 == 0 ? 0.7 : -0.5, v % 3 == 0 ? 0.4 : -0.3);
    longer.col(v) = longer.col(v - 1) + length * step;
  }
  return longer;
}

Points polyline(std::initializer_list<Eigen::Vector3d> points) {
  Points x(3, points.size());
  int column = 0;
  for (const Eigen::Vector3d& point : points) x.col(column++) = point;
  return x;
}

}  // namespace

const char* shape_name(Shape shape) {
  const char* const names[] = {"generic",    "nearly straight", "nearly folded",
                               "nearly cis", "nearly trans",    "nearly straight end"};
  return names[static_cast<int>(shape)];
}

Points random_points(std::mt19937_64& random, int count) {
  Points points(3, count);
  for (double& value : points.reshaped()) value = random_between(random, -1, 1);
  return points;
}

Eigen::Matrix3d random_rotation(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const Eigen::Vector4d coefficients(normal(random), normal(random), normal(random),
                                     normal(random));
  return Eigen::Quaterniond(coefficients).normalized().toRotationMatrix();
}

Points random_strand(std::mt19937_64& random, int vertices, Shape shape, double nearly) {
  const double small = nearly * random_between(random, 0.5, 1);
  double bend = random_between(random, 0.3, 2.8), torsion = random_between(random, -3, 3);
  const double last_bend = random_between(random, 0.3, 2.8);
  if (shape == Shape::nearly_straight || shape == Shape::straight_end) bend = small;
  if (shape == Shape::nearly_folded) bend = pi - small;
  if (shape == Shape::nearly_cis) torsion = small;
  if (shape == Shape::nearly_trans) torsion = pi - small;

  // The second edge lies along x; bend is the angle by which the strand turns at its start.
  Points x = Points::Zero(3, 4);
  x.col(0) = random_between(random, 0.5, 2) * Eigen::Vector3d(-std::cos(bend), std::sin(bend), 0);
  x.col(2) = Eigen::Vector3d(random_between(random, 0.5, 2), 0, 0);
  const Eigen::Vector3d last(std::cos(last_bend), std::sin(last_bend) * std::cos(torsion),
                             std::sin(last_bend) * std::sin(torsion));
  x.col(3) = x.col(2) + random_between(random, 0.5, 2) * last;
  const Eigen::Matrix3d rotation = random_rotation(random);
  const Eigen::Vector3d origin = random_points(random, 1);
  const Points placed = (rotation * x).colwise() + origin;
  return with_vertices(placed, vertices);
}

std::vector<NamedShape> singular_shapes(int vertices) {
  const Eigen::Vector3d o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), d(0.3, -0.7, 0.55);
  std::vector<NamedShape> shapes{{"straight along an axis", polyline({o, x, 2 * x, 3 * x})},
                                 {"straight askew", polyline({o, d, 2 * d, 3 * d})},
                                 {"straight, unequal", polyline({o, 0.1 * d, 2 * d, 2.3 * d})},
                                 {"folded", polyline({o, d, o, d})},
                                 {"folded, unequal", polyline({o, d, 0.4 * d, 1.1 * d})},
                                 {"planar zigzag", polyline({o, x + y, 2 * x, 3 * x + y})},
                                 {"planar arc", polyline({o, x + y, 2 * x + y, 3 * x})},
                                 {"first edge parallel", polyline({o, x, 2 * x, 2 * x + y})},
                                 {"last edge parallel", polyline({y, o, x, 3 * x})},
                                 {"first edge folded", polyline({1.5 * x, o, x, x + z})},
                                 {"first edge collapsed", polyline({o, o, x, x + y})},
                                 {"middle edge collapsed", polyline({y, o, o, x})},
                                 {"last edge collapsed", polyline({y, o, x, x})},
                                 {"all in one point", polyline({d, d, d, d})}};
  for (NamedShape& shape : shapes) shape.x = with_vertices(shape.x, vertices);
  return shapes;
}

std::vector<NamedShape> degenerate_shapes(std::mt19937_64& random, int vertices) {
  std::vector<NamedShape> shapes = singular_shapes(vertices);
  const Points generic = random_strand(random, vertices, Shape::generic);
  for (const double scale : {1e-5, 1e-9, 1e-15, 1e-100, 1e-160, 1e-300, 1e6, 1e30}) {
    shapes.push_back({fmt::format("everything times {}", scale), scale * generic});
  }
  for (const Shape shape : all_shapes) {
    for (double nearly = 1e-2; nearly > 1e-19; nearly *= 0.1) {
      shapes.push_back({fmt::format("{}, {:.0e}", shape_name(shape), nearly),
                        random_strand(random, vertices, shape, nearly)});
    }
  }
  return shapes;
}

}  // namespace ringlet
