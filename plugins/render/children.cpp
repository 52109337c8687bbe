#include "plugins/render/children.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "core/error.h"
#include "core/parallel.h"
#include "plugins/render/hash.h"
#include "plugins/render/strand_frames.h"

namespace ringlet {
namespace {

/// The last part of a child, in which it gets thin.
constexpr double tip_part = 0.1;
/// Children end at this part of the strand or later.
constexpr double shortest = 0.85;

/// One strand, and what children need to know of it.
class Guide {
 public:
  Guide(const StrandShapes& strands, int strand, int first_vertex)
      : number_(static_cast<std::uint64_t>(strand)),
        count_(strands.vertex_counts[strand]),
        vertices_(strands.positions.middleCols(first_vertex, count_)),
        radii_(&strands.radii[first_vertex]),
        frames_(parallel_frames(vertices_)),
        arc_(count_) {
    for (int i = 1; i < count_; ++i) {
      arc_[i] = arc_[i - 1] + (vertices_.col(i) - vertices_.col(i - 1)).norm();
    }
    mean_radius_ = std::accumulate(radii_, radii_ + count_, 0.0) / count_;
  }

  std::uint64_t number() const { return number_; }
  int count() const { return count_; }
  double mean_radius() const { return mean_radius_; }

  /// What is at a place between vertices: 2.5 is in the middle between the third and the fourth.
  struct Place {
    Eigen::Vector3d centre, first, second;
    double radius, arc;
  };
  Place at(double t) const {
    const int i = std::clamp(static_cast<int>(t), 0, std::max(0, count_ - 2));
    const int j = std::min(i + 1, count_ - 1);
    const double u = t - i;
    const auto mixed = [u](const auto& a, const auto& b) { return ((1 - u) * a + u * b).eval(); };
    return {curve_at(i, j, u), mixed(frames_.first[i], frames_.first[j]),
            mixed(frames_.second[i], frames_.second[j]), (1 - u) * radii_[i] + u * radii_[j],
            (1 - u) * arc_[i] + u * arc_[j]};
  }

 private:
  /// The Catmull-Rom curve that the strand itself is drawn as.
  Eigen::Vector3d curve_at(int i, int j, double u) const {
    const Eigen::Vector3d a = vertices_.col(i), b = vertices_.col(j);
    const Eigen::Vector3d before = i > 0 ? Eigen::Vector3d(vertices_.col(i - 1)) : 2 * a - b;
    const Eigen::Vector3d after =
        j + 1 < count_ ? Eigen::Vector3d(vertices_.col(j + 1)) : 2 * b - a;
    const double v = 1 - u;
    return 0.5 * (-u * v * v * before + (2 + u * u * (3 * u - 5)) * a +
                  (2 + v * v * (3 * v - 5)) * b - v * u * u * after);
  }

  std::uint64_t number_;
  int count_;
  Eigen::Ref<const Eigen::Matrix3Xd> vertices_;
  const double* radii_;
  StrandFrames frames_;
  std::vector<double> arc_;  // m, from the root
  double mean_radius_ = 0;
};

/// What makes a child another than its siblings.
class Child {
 public:
  Child(const Guide& guide, int number, const ChildParameters& parameters)
      : parameters_(parameters) {
    const auto chance = [&](int what) {
      return hashed_uniform(guide.number(), static_cast<std::uint64_t>(number),
                            static_cast<std::uint64_t>(what));
    };
    // The square root spreads children evenly over the disc.
    const double distance = std::sqrt(chance(0)), angle = 2 * std::numbers::pi * chance(1);
    offset_ = distance * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    length_ = 1 - (1 - shortest) * chance(2) * chance(2);
    const double widest = std::max(guide.mean_radius(), 1e-12);
    for (int wave = 0; wave < waves; ++wave) {
      const double wave_length = widest * (8 + 24 * chance(3 + 2 * wave));
      frequency_[wave] = 2 * std::numbers::pi / wave_length;
      phase_[wave] = 2 * std::numbers::pi * chance(4 + 2 * wave);
    }
  }

  double length() const { return length_; }
  /// In the disc of radius 1, at an arc length from the root, m.
  Eigen::Vector2d offset(double arc) const {
    Eigen::Vector2d wander{0, 0};
    for (int wave = 0; wave < waves; ++wave) {
      wander[wave % 2] += std::sin(frequency_[wave] * arc + phase_[wave]);
    }
    // Each sum is at most 2, and so the length of both at most the square root of 8.
    const double within_disc = parameters_.frizz / std::sqrt(8.0);
    return (1 - parameters_.frizz) * offset_ + within_disc * wander;
  }

 private:
  static constexpr int waves = 4;
  const ChildParameters& parameters_;
  Eigen::Vector2d offset_;
  double length_ = 1;  // of the strand's
  double frequency_[waves], phase_[waves];
};

CurvePoint make_point(const Eigen::Vector3d& point, double radius) {
  return {static_cast<float>(point.x()), static_cast<float>(point.y()),
          static_cast<float>(point.z()), static_cast<float>(radius)};
}

/// The points before the first and after the last one go straight on.
void extend(CurvePoint* points, int count) {
  const auto beyond = [](const CurvePoint& end, const CurvePoint& inner) {
    return CurvePoint{2 * end.x - inner.x, 2 * end.y - inner.y, 2 * end.z - inner.z, end.radius};
  };
  points[0] = beyond(points[1], points[2]);
  points[count + 1] = beyond(points[count], points[count - 1]);
}

void write_strand(const Guide& guide, const Eigen::Vector3d& origin, CurvePoint* points) {
  for (int i = 0; i < guide.count(); ++i) {
    const Guide::Place place = guide.at(i);
    points[i + 1] = make_point(place.centre - origin, place.radius);
  }
  extend(points, guide.count());
}

void write_child(const Guide& guide, const Child& child, const ChildParameters& parameters,
                 const Eigen::Vector3d& origin, CurvePoint* points) {
  for (int i = 0; i < guide.count(); ++i) {
    const double part = static_cast<double>(i) / std::max(1, guide.count() - 1);
    const Guide::Place place = guide.at(child.length() * i);
    const Eigen::Vector2d offset = parameters.spread * place.radius * child.offset(place.arc);
    const double thickness = std::min(1.0, 0.2 + 0.8 * (1 - part) / tip_part);
    points[i + 1] =
        make_point(place.centre + offset.x() * place.first + offset.y() * place.second - origin,
                   thickness * parameters.radius);
  }
  extend(points, guide.count());
}

/// Room for all points, and the segments between them.
Curves lay_out(const StrandShapes& strands, int per_strand) {
  Curves curves;
  curves.per_strand = per_strand;
  std::uint64_t points = 0, segments = 0;
  for (const int count : strands.vertex_counts) {
    points += static_cast<std::uint64_t>(per_strand) * static_cast<std::uint64_t>(count + 2);
    segments += static_cast<std::uint64_t>(per_strand) * static_cast<std::uint64_t>(count - 1);
  }
  if (points > std::numeric_limits<std::uint32_t>::max()) {
    throw Error("these are too many hairs to draw at once; expected fewer 'children'");
  }
  curves.points.resize(points);
  curves.segments.reserve(segments);
  std::uint32_t point = 0;
  for (const int count : strands.vertex_counts) {
    curves.strand_segments.push_back(static_cast<std::uint32_t>(curves.segments.size()));
    for (int child = 0; child < per_strand; ++child) {
      for (int i = 0; i + 1 < count; ++i) curves.segments.push_back(point++);
      point += 3;
    }
  }
  curves.strand_segments.push_back(static_cast<std::uint32_t>(curves.segments.size()));
  return curves;
}

}  // namespace

Curves make_curves(const StrandShapes& strands, const ChildParameters& parameters,
                   const Eigen::Vector3d& origin) {
  const int per_strand = std::max(1, parameters.count);
  Curves curves = lay_out(strands, per_strand);
  std::vector<int> first_vertex{0};
  std::vector<std::size_t> first_point{0};
  for (const int count : strands.vertex_counts) {
    first_vertex.push_back(first_vertex.back() + count);
    first_point.push_back(first_point.back() + static_cast<std::size_t>(per_strand) *
                                                   static_cast<std::size_t>(count + 2));
  }
  parallel_for_each(static_cast<int>(strands.vertex_counts.size()), [&](int strand) {
    const Guide guide(strands, strand, first_vertex[strand]);
    CurvePoint* points = &curves.points[first_point[strand]];
    if (parameters.count == 0) return write_strand(guide, origin, points);
    for (int number = 0; number < parameters.count; ++number, points += guide.count() + 2) {
      write_child(guide, Child(guide, number, parameters), parameters, origin, points);
    }
  });
  return curves;
}

}  // namespace ringlet
