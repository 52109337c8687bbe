#include "plugins/render/bundle_geometry.h"

#include <algorithm>
#include <limits>

#include "core/parallel.h"
#include "plugins/render/curves.h"
#include "plugins/render/hash.h"

namespace ringlet {
namespace {

std::uint64_t number_of_hair(std::uint32_t bundle, int lane) {
  return std::uint64_t{bundle} * hair_lanes + static_cast<std::uint64_t>(lane);
}

}  // namespace

RayContext::RayContext(const RayFrame& ray_frame, unsigned chance)
    : context{}, frame(ray_frame), number(chance) {
  rtcInitIntersectContext(&context);
}

BundleGeometry::BundleGeometry(Bundles bundles, float transmitted)
    : bundles_(std::move(bundles)), tubes_(bundles_.segments.size()), transmitted_(transmitted) {
  constexpr std::size_t at_once = 4096;
  const std::size_t parts = (tubes_.size() + at_once - 1) / at_once;
  parallel_for_each(static_cast<int>(parts), [&](int part) {
    const std::size_t begin = at_once * static_cast<std::size_t>(part);
    for (std::size_t i = begin; i < std::min(begin + at_once, tubes_.size()); ++i) {
      const std::uint32_t point = bundles_.segments[i].point;
      tubes_[i] = tube_around(&bundles_.points[point], thickest(point));
    }
  });
}

float BundleGeometry::thickest(std::uint32_t point) const {
  return std::max(bundles_.radii[point + 1], bundles_.radii[point + 2]);
}

RTCGeometry BundleGeometry::make(RTCDevice device) const {
  const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(bundles_.segments.size()));
  rtcSetGeometryUserData(geometry, const_cast<BundleGeometry*>(this));
  rtcSetGeometryBoundsFunction(geometry, find_bounds, nullptr);
  rtcSetGeometryIntersectFunction(geometry, intersect);
  rtcSetGeometryOccludedFunction(geometry, occlude);
  return geometry;
}

void BundleGeometry::find_bounds(const RTCBoundsFunctionArguments* arguments) {
  const auto& self = *static_cast<const BundleGeometry*>(arguments->geometryUserPtr);
  const std::uint32_t point = self.bundles_.segments[arguments->primID].point;
  const auto [low, high] = bounds(&self.bundles_.points[point], self.thickest(point));
  RTCBounds& box = *arguments->bounds_o;
  box.lower_x = low.x(), box.lower_y = low.y(), box.lower_z = low.z();
  box.upper_x = high.x(), box.upper_y = high.y(), box.upper_z = high.z();
}

LaneHits BundleGeometry::trace_segment(const Bundles::Segment& segment, const RTCRay& ray,
                                       const RayContext& context) const {
  return trace(&bundles_.points[segment.point], &bundles_.radii[segment.point + 1], context.frame,
               ray.tnear, ray.tfar);
}

bool BundleGeometry::is_beyond_tip(const Bundles::Segment& segment, int lane, float u) const {
  return static_cast<float>(segment.vertex) + u >
         bundles_.ends[number_of_hair(segment.bundle, lane)];
}

bool BundleGeometry::goes_through(const RayContext& context, std::uint64_t hair) const {
  return hashed_uniform(context.number, hair) < transmitted_;
}

// Only single rays are traced here, so that N is 1.
void BundleGeometry::intersect(const RTCIntersectFunctionNArguments* arguments) {
  if (arguments->valid[0] == 0) return;
  const auto& self = *static_cast<const BundleGeometry*>(arguments->geometryUserPtr);
  const auto& context = *reinterpret_cast<const RayContext*>(arguments->context);
  auto& found = *reinterpret_cast<RTCRayHit*>(arguments->rayhit);
  if (!may_meet(self.tubes_[arguments->primID], context.frame, found.ray.tnear, found.ray.tfar))
    return;
  const Bundles::Segment& segment = self.bundles_.segments[arguments->primID];
  const LaneHits hits = self.trace_segment(segment, found.ray, context);
  for (int lane = 0; lane < hair_lanes; ++lane) {
    if (!(hits.distance[lane] < found.ray.tfar)) continue;
    if (self.is_beyond_tip(segment, lane, hits.u[lane])) continue;
    found.ray.tfar = hits.distance[lane];
    found.hit.u = hits.u[lane];
    found.hit.v = static_cast<float>(lane);
    found.hit.primID = arguments->primID;
    found.hit.geomID = arguments->geomID;
  }
}

void BundleGeometry::occlude(const RTCOccludedFunctionNArguments* arguments) {
  if (arguments->valid[0] == 0) return;
  const auto& self = *static_cast<const BundleGeometry*>(arguments->geometryUserPtr);
  const auto& context = *reinterpret_cast<const RayContext*>(arguments->context);
  auto& ray = *reinterpret_cast<RTCRay*>(arguments->ray);
  if (!may_meet(self.tubes_[arguments->primID], context.frame, ray.tnear, ray.tfar)) return;
  const Bundles::Segment& segment = self.bundles_.segments[arguments->primID];
  const LaneHits hits = self.trace_segment(segment, ray, context);
  for (int lane = 0; lane < hair_lanes; ++lane) {
    if (!(hits.distance[lane] < ray.tfar)) continue;
    if (self.is_beyond_tip(segment, lane, hits.u[lane])) continue;
    if (self.goes_through(context, number_of_hair(segment.bundle, lane))) continue;
    ray.tfar = -std::numeric_limits<float>::infinity();
    return;
  }
}

BundleGeometry::Hair BundleGeometry::hair_of(const RTCHit& hit) const {
  const Bundles::Segment& segment = bundles_.segments[hit.primID];
  const int lane = static_cast<int>(hit.v);
  const Eigen::Array4f slope = catmull_rom_slope(hit.u);
  Eigen::Vector3f tangent = Eigen::Vector3f::Zero();
  for (int i = 0; i < 4; ++i) {
    tangent += slope[i] * bundles_.points[segment.point + static_cast<unsigned>(i)].of(lane);
  }
  return {tangent.stableNormalized(), bundles_.radii[segment.point + 1],
          number_of_hair(segment.bundle, lane)};
}

}  // namespace ringlet
