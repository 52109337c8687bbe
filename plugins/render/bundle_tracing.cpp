#include "plugins/render/bundle_tracing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace ringlet {
namespace {

/// A segment of a curve is met as that many straight pieces.
constexpr int pieces = 4;

/// How much each of four points counts for a Catmull-Rom curve, where pieces meet.
struct Weights {
  float of[pieces + 1][4];
};
constexpr Weights make_weights() {
  Weights weights{};
  for (int i = 0; i <= pieces; ++i) {
    const float u = static_cast<float>(i) / pieces, v = 1 - u;
    weights.of[i][0] = -0.5F * u * v * v;
    weights.of[i][1] = 0.5F * (2 + u * u * (3 * u - 5));
    weights.of[i][2] = 0.5F * (2 + v * v * (3 * v - 5));
    weights.of[i][3] = -0.5F * v * u * u;
  }
  return weights;
}
constexpr Weights weights = make_weights();

/// Where pieces meet.
void pieces_of(const LanePoints* points, LanePoints* ends) {
  for (int i = 0; i <= pieces; ++i) {
    const float* w = weights.of[i];
    for (int l = 0; l < hair_lanes; ++l) {
      ends[i].x[l] = w[0] * points[0].x[l] + w[1] * points[1].x[l] + w[2] * points[2].x[l] +
                     w[3] * points[3].x[l];
      ends[i].y[l] = w[0] * points[0].y[l] + w[1] * points[1].y[l] + w[2] * points[2].y[l] +
                     w[3] * points[3].y[l];
      ends[i].z[l] = w[0] * points[0].z[l] + w[1] * points[1].z[l] + w[2] * points[2].z[l] +
                     w[3] * points[3].z[l];
    }
  }
}

Eigen::Vector3f mean_of(const LanePoints& points) {
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (int l = 0; l < hair_lanes; ++l) sum += points.of(l);
  return sum / hair_lanes;
}

float squared_distance(const Eigen::Vector3f& point, const Eigen::Vector3f& from,
                       const Eigen::Vector3f& to) {
  const Eigen::Vector3f way = to - from, offset = point - from;
  const float squared = way.squaredNorm();
  const float s = squared > 0 ? std::clamp(offset.dot(way) / squared, 0.0F, 1.0F) : 0;
  return (offset - s * way).squaredNorm();
}

/// Of a piece of a tube, across a ray, from the ray.
float squared_distance(const Eigen::Vector2f& start, const Eigen::Vector2f& end) {
  const Eigen::Vector2f way = end - start;
  const float s = std::clamp(-start.dot(way) / (way.squaredNorm() + 1e-30F), 0.0F, 1.0F);
  return (start + s * way).squaredNorm();
}

/// Rounding must not lose what is just inside.
constexpr float slack = 1.0001F;

/// Points as seen along a ray: across it, and how far.
struct alignas(64) LaneView {
  float a[hair_lanes], b[hair_lanes], depth[hair_lanes];
};

void view(const LanePoints& points, const RayFrame& ray, LaneView& out) {
  for (int l = 0; l < hair_lanes; ++l) {
    const float x = points.x[l] - ray.origin.x();
    const float y = points.y[l] - ray.origin.y();
    const float z = points.z[l] - ray.origin.z();
    out.a[l] = x * ray.first.x() + y * ray.first.y() + z * ray.first.z();
    out.b[l] = x * ray.second.x() + y * ray.second.y() + z * ray.second.z();
    out.depth[l] = x * ray.along.x() + y * ray.along.y() + z * ray.along.z();
  }
}

void mix(const LaneView* corners, const float* weight, LaneView& out) {
  for (int l = 0; l < hair_lanes; ++l) {
    out.a[l] = weight[0] * corners[0].a[l] + weight[1] * corners[1].a[l] +
               weight[2] * corners[2].a[l] + weight[3] * corners[3].a[l];
    out.b[l] = weight[0] * corners[0].b[l] + weight[1] * corners[1].b[l] +
               weight[2] * corners[2].b[l] + weight[3] * corners[3].b[l];
    out.depth[l] = weight[0] * corners[0].depth[l] + weight[1] * corners[1].depth[l] +
                   weight[2] * corners[2].depth[l] + weight[3] * corners[3].depth[l];
  }
}

/// A straight piece whose nearest point to the ray is nearer than its radius there, and nearer than
/// what was met before, is the new hit.
void meet(const LaneView& start, const LaneView& end, float first_radius, float last_radius,
          int piece, float from, LaneHits& hits) {
  for (int l = 0; l < hair_lanes; ++l) {
    const float da = end.a[l] - start.a[l], db = end.b[l] - start.b[l];
    const float squared = da * da + db * db;
    const float wanted = -(start.a[l] * da + start.b[l] * db) / (squared + 1e-30F);
    const float s = wanted < 0 ? 0 : wanted > 1 ? 1 : wanted;
    const float a = start.a[l] + s * da, b = start.b[l] + s * db;
    const float depth = start.depth[l] + s * (end.depth[l] - start.depth[l]);
    const float radius = first_radius + s * (last_radius - first_radius);
    // Written without && so that lanes need no branches.
    const bool is_hit =
        (a * a + b * b < radius * radius) & (depth > from) & (depth < hits.distance[l]);
    hits.distance[l] = is_hit ? depth : hits.distance[l];
    hits.u[l] = is_hit ? (static_cast<float>(piece) + s) / pieces : hits.u[l];
  }
}

}  // namespace

RayFrame::RayFrame(const Eigen::Vector3f& start, const Eigen::Vector3f& direction)
    : origin(start), along(direction) {
  int axis = 0;
  along.cwiseAbs().minCoeff(&axis);
  first = along.cross(Eigen::Vector3f::Unit(axis)).normalized();
  second = along.cross(first);
}

LaneHits trace(const LanePoints* points, const float* radii, const RayFrame& ray, float from,
               float to) {
  LaneHits hits;
  for (int l = 0; l < hair_lanes; ++l) hits.distance[l] = to, hits.u[l] = 0;
  LaneView corners[4], ends[2];
  for (int i = 0; i < 4; ++i) view(points[i], ray, corners[i]);
  ends[0] = corners[1];
  for (int piece = 0; piece < pieces; ++piece) {
    const float begin = static_cast<float>(piece) / pieces;
    const float end = static_cast<float>(piece + 1) / pieces;
    const float taper = radii[1] - radii[0];
    LaneView& start = ends[piece % 2];
    LaneView& stop = ends[1 - piece % 2];
    mix(corners, weights.of[piece + 1], stop);
    meet(start, stop, radii[0] + begin * taper, radii[0] + end * taper, piece, from, hits);
  }
  return hits;
}

std::array<Eigen::Vector3f, 2> bounds(const LanePoints* points, float radius) {
  LanePoints ends[pieces + 1];
  pieces_of(points, ends);
  LanePoints low = ends[0], high = ends[0];
  for (int i = 1; i <= pieces; ++i) {
    for (int l = 0; l < hair_lanes; ++l) {
      low.x[l] = std::min(low.x[l], ends[i].x[l]), high.x[l] = std::max(high.x[l], ends[i].x[l]);
      low.y[l] = std::min(low.y[l], ends[i].y[l]), high.y[l] = std::max(high.y[l], ends[i].y[l]);
      low.z[l] = std::min(low.z[l], ends[i].z[l]), high.z[l] = std::max(high.z[l], ends[i].z[l]);
    }
  }
  std::array<Eigen::Vector3f, 2> box{low.of(0), high.of(0)};
  for (int l = 1; l < hair_lanes; ++l) {
    box[0] = box[0].cwiseMin(low.of(l));
    box[1] = box[1].cwiseMax(high.of(l));
  }
  box[0].array() -= slack * radius;
  box[1].array() += slack * radius;
  return box;
}

// A piece lies in what is nearer than some distance to a straight line if its ends do.
Tube tube_around(const LanePoints* points, float radius) {
  static_assert(pieces % 2 == 0);
  LanePoints ends[pieces + 1];
  pieces_of(points, ends);
  Tube tube{mean_of(ends[0]), mean_of(ends[pieces / 2]), mean_of(ends[pieces]), 0};
  float squared = 0;
  for (int i = 0; i <= pieces; ++i) {
    for (int l = 0; l < hair_lanes; ++l) {
      const Eigen::Vector3f end = ends[i].of(l);
      if (i <= pieces / 2) {
        squared = std::max(squared, squared_distance(end, tube.start, tube.middle));
      }
      if (i >= pieces / 2)
        squared = std::max(squared, squared_distance(end, tube.middle, tube.end));
    }
  }
  tube.radius = slack * (std::sqrt(squared) + radius);
  return tube;
}

bool may_meet(const Tube& tube, const RayFrame& ray, float from, float to) {
  const auto across = [&](const Eigen::Vector3f& offset) {
    return Eigen::Vector2f(offset.dot(ray.first), offset.dot(ray.second));
  };
  const Eigen::Vector3f start = tube.start - ray.origin, middle = tube.middle - ray.origin,
                        end = tube.end - ray.origin;
  const Eigen::Vector2f a = across(start), b = across(middle), c = across(end);
  const float squared = tube.radius * tube.radius;
  if (squared_distance(a, b) > squared && squared_distance(b, c) > squared) return false;
  const float first = start.dot(ray.along), second = middle.dot(ray.along),
              third = end.dot(ray.along);
  return std::max({first, second, third}) + tube.radius > from &&
         std::min({first, second, third}) - tube.radius < to;
}

}  // namespace ringlet
