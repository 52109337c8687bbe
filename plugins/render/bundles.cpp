#include "plugins/render/bundles.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "core/error.h"
#include "core/parallel.h"

namespace ringlet {
namespace {

/// The last part of a child, in which it gets thin.
constexpr double tip_part = 0.1;
constexpr double tip_thickness = 0.2;

/// Halves children, by their place along one axis and the other in turn, until they fit into the
/// lanes: neighbours so come together.
template <class Take>
void split(std::vector<Child>& children, std::size_t begin, std::size_t end, int axis,
           const Take& take) {
  if (end - begin <= hair_lanes) return take(begin, end);
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::size_t i) { return children.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end), [axis](const Child& a, const Child& b) {
    return a.place()[axis] < b.place()[axis];
  });
  split(children, begin, middle, 1 - axis, take);
  split(children, middle, end, 1 - axis, take);
}

/// How many bundles split() makes.
int bundles_of(int children) {
  if (children <= hair_lanes) return 1;
  return bundles_of(children / 2) + bundles_of(children - children / 2);
}

/// Room for all points; where those of each strand begin.
struct Layout {
  std::vector<std::size_t> first_point, first_bundle;
  std::vector<int> first_vertex;
};

Layout lay_out(const StrandShapes& strands, int per_strand, Bundles& bundles) {
  Layout layout;
  std::size_t points = 0, bundle = 0;
  int vertex = 0;
  for (const int count : strands.vertex_counts) {
    layout.first_point.push_back(points);
    layout.first_bundle.push_back(bundle);
    layout.first_vertex.push_back(vertex);
    vertex += count;
    bundle += static_cast<std::size_t>(per_strand);
    points += static_cast<std::size_t>(per_strand) * static_cast<std::size_t>(count + 2);
  }
  if (points > std::numeric_limits<std::uint32_t>::max()) {
    throw Error("these are too many hairs to draw; expected fewer 'children'");
  }
  bundles.points.resize(points);
  bundles.radii.resize(points);
  bundles.ends.resize(bundle * hair_lanes, -1);
  std::uint32_t point = 0, number = 0;
  for (const int count : strands.vertex_counts) {
    for (int b = 0; b < per_strand; ++b, ++number, point += 3) {
      for (int i = 0; i + 1 < count; ++i) {
        bundles.segments.push_back({point++, number, static_cast<std::uint32_t>(i)});
      }
    }
  }
  return layout;
}

void set(LanePoints& points, int lane, const Eigen::Vector3f& point) {
  points.x[lane] = point.x();
  points.y[lane] = point.y();
  points.z[lane] = point.z();
}

/// Writes one hair into a lane. The points before the first and after the last go straight on.
void write(Child& child, const Guide& guide, const Eigen::Vector3d& origin, int lane,
           LanePoints* points) {
  child.for_each_point(guide, [&](int i, const Eigen::Vector3d& point) {
    set(points[i + 1], lane, (point - origin).cast<float>());
  });
  const int last = guide.count();
  const auto beyond = [&](int end, int inner) {
    return Eigen::Vector3f(2 * points[end].of(lane) - points[inner].of(lane));
  };
  set(points[0], lane, beyond(1, std::min(2, last)));
  set(points[last + 1], lane, beyond(last, std::max(last - 1, 1)));
}

void repeat_first(int from_lane, LanePoints& points) {
  for (int lane = from_lane; lane < hair_lanes; ++lane) set(points, lane, points.of(0));
}

void write_radii(int count, double radius, float* radii) {
  for (int i = -1; i <= count; ++i) {
    const double left = 1 - std::clamp(static_cast<double>(i) / std::max(1, count - 1), 0.0, 1.0);
    const double part = std::min(1.0, tip_thickness + (1 - tip_thickness) * left / tip_part);
    *radii++ = static_cast<float>(part * radius);
  }
}

}  // namespace

Bundles make_bundles(const StrandShapes& strands, const ChildParameters& parameters,
                     const Eigen::Vector3d& origin) {
  Bundles bundles;
  const Layout layout = lay_out(strands, bundles_of(parameters.count), bundles);
  parallel_for_each(static_cast<int>(strands.vertex_counts.size()), [&](int strand) {
    const Guide guide(strands, strand, layout.first_vertex[strand]);
    const auto stride = static_cast<std::size_t>(guide.count() + 2);
    std::vector<Child> children;
    for (int i = 0; i < parameters.count; ++i) children.emplace_back(guide, i, parameters);
    std::size_t point = layout.first_point[strand], bundle = layout.first_bundle[strand];
    split(children, 0, children.size(), 0, [&](std::size_t begin, std::size_t end) {
      const int hairs = static_cast<int>(end - begin);
      LanePoints* points = &bundles.points[point];
      float* ends = &bundles.ends[hair_lanes * bundle++];
      for (int lane = 0; lane < hairs; ++lane) {
        Child& child = children[begin + static_cast<std::size_t>(lane)];
        write(child, guide, origin, lane, points);
        *ends++ = static_cast<float>(child.end());
      }
      for (std::size_t i = 0; i < stride; ++i) repeat_first(hairs, points[i]);
      write_radii(guide.count(), parameters.radius, &bundles.radii[point]);
      point += stride;
    });
  });
  return bundles;
}

}  // namespace ringlet
