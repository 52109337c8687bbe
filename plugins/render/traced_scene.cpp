#include "plugins/render/traced_scene.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace ringlet {
namespace {

void check(RTCDevice device) {
  const RTCError error = rtcGetDeviceError(device);
  if (error == RTC_ERROR_NONE) return;
  if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  throw Error("Embree failed with its error " + std::to_string(error));
}

/// An edge is drawn sharp where a normal differs from that of the face by more than 35 degrees.
constexpr float sharp_cosine = 0.82F;

std::vector<Eigen::Vector3f> vertex_normals(const Triangles& triangles) {
  std::vector<Eigen::Vector3f> normals(triangles.vertices.size(), Eigen::Vector3f::Zero());
  for (const auto& corner : triangles.corners) {
    const Eigen::Vector3d a = triangles.vertices[corner[0]];
    const Eigen::Vector3d weighted =
        (triangles.vertices[corner[1]] - a).cross(triangles.vertices[corner[2]] - a);
    for (const int vertex : corner) normals[vertex] += weighted.normalized().cast<float>();
  }
  for (Eigen::Vector3f& normal : normals) normal.normalize();
  return normals;
}

RTCRay to_embree(const Ray& ray) {
  RTCRay out{};
  out.org_x = ray.origin.x(), out.org_y = ray.origin.y(), out.org_z = ray.origin.z();
  out.dir_x = ray.direction.x(), out.dir_y = ray.direction.y(), out.dir_z = ray.direction.z();
  out.tnear = ray.from, out.tfar = ray.to;
  out.mask = ~0U;
  return out;
}

}  // namespace

TracedScene::TracedScene(Curves curves, Bundles bundles, float transmitted,
                         const std::vector<DrawnShape>& shapes, const Eigen::Vector3d& origin)
    : origin_(origin),
      curves_(std::move(curves)),
      bundles_(std::move(bundles), transmitted),
      device_(rtcNewDevice(nullptr)),
      scene_(device_ == nullptr ? nullptr : rtcNewScene(device_)) {
  if (scene_ == nullptr) throw Error("Embree cannot be used on this machine");
  if (!curves_.segments.empty()) add_curves();
  if (!bundles_.is_empty()) bundles_id_ = attach(bundles_.make(device_));
  for (const DrawnShape& shape : shapes) {
    std::visit([this](const auto& one) { add(one); }, shape);
  }
  rtcCommitScene(scene_);
  check(device_);
}

TracedScene::~TracedScene() {
  rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

unsigned TracedScene::attach(RTCGeometry geometry) {
  rtcCommitGeometry(geometry);
  const unsigned id = rtcAttachGeometry(scene_, geometry);
  rtcReleaseGeometry(geometry);
  surfaces_.resize(std::max<std::size_t>(surfaces_.size(), id + 1));
  return id;
}

Eigen::Vector3f TracedScene::relative(const Eigen::Vector3d& point) const {
  return (point - origin_).cast<float>();
}

void TracedScene::add_curves() {
  const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_ROUND_CATMULL_ROM_CURVE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                             curves_.points.data(), 0, sizeof(CurvePoint), curves_.points.size());
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT,
                             curves_.segments.data(), 0, sizeof(std::uint32_t),
                             curves_.segments.size());
  curves_id_ = attach(geometry);
}

void TracedScene::add(const Ball& ball) {
  const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  auto* centre = static_cast<CurvePoint*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, sizeof(CurvePoint), 1));
  const Eigen::Vector3f point = relative(ball.centre);
  *centre = {point.x(), point.y(), point.z(), static_cast<float>(ball.radius)};
  attach(geometry);
}

void TracedScene::add(const Capsule& capsule) {
  const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE);
  auto* ends = static_cast<CurvePoint*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, sizeof(CurvePoint), 2));
  auto* first = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT, sizeof(std::uint32_t), 1));
  const Eigen::Vector3f from = relative(capsule.from), to = relative(capsule.to);
  const auto radius = static_cast<float>(capsule.radius);
  ends[0] = {from.x(), from.y(), from.z(), radius};
  ends[1] = {to.x(), to.y(), to.z(), radius};
  *first = 0;
  attach(geometry);
}

void TracedScene::add(const Plane& plane) {
  const Eigen::Vector3f normal = plane.normal.cast<float>();
  planes_.push_back({normal, normal.dot(relative(plane.point))});
}

void TracedScene::add(const Triangles& triangles) {
  const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                                             RTC_FORMAT_FLOAT3, 3 * sizeof(float),
                                                             triangles.vertices.size()));
  auto* corner = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                              3 * sizeof(std::uint32_t), triangles.corners.size()));
  check(device_);
  for (const Eigen::Vector3d& point : triangles.vertices) {
    for (const float coordinate : relative(point)) *vertex++ = coordinate;
  }
  for (const auto& corners : triangles.corners) {
    for (const int index : corners) *corner++ = static_cast<std::uint32_t>(index);
  }
  surfaces_[attach(geometry)] = {vertex_normals(triangles), triangles.corners};
}

Hit TracedScene::hit_of(const RTCRayHit& found) const {
  if (found.hit.geomID == curves_id_) return hit_of_curve(found);
  if (found.hit.geomID != bundles_id_) return hit_of_surface(found);
  const BundleGeometry::Hair hair = bundles_.hair_of(found.hit);
  return {Hit::Kind::hair, found.ray.tfar, hair.tangent, hair.radius, hair.number};
}

Hit TracedScene::hit_of_curve(const RTCRayHit& found) const {
  const CurvePoint* points = &curves_.points[curves_.segments[found.hit.primID]];
  const Eigen::Array4f slope = catmull_rom_slope(found.hit.u);
  Eigen::Vector3f tangent = Eigen::Vector3f::Zero();
  for (int i = 0; i < 4; ++i) {
    tangent += slope[i] * Eigen::Vector3f(points[i].x, points[i].y, points[i].z);
  }
  return {Hit::Kind::hair, found.ray.tfar, tangent.stableNormalized(), points[1].radius,
          curves_.strands[found.hit.primID]};
}

Hit TracedScene::hit_of_surface(const RTCRayHit& found) const {
  Eigen::Vector3f normal(found.hit.Ng_x, found.hit.Ng_y, found.hit.Ng_z);
  normal.normalize();
  const Surface& surface = surfaces_[found.hit.geomID];
  if (!surface.normals.empty()) {
    const auto& corner = surface.corners[found.hit.primID];
    const float u = found.hit.u, v = found.hit.v;
    const Eigen::Vector3f smooth = ((1 - u - v) * surface.normals[corner[0]] +
                                    u * surface.normals[corner[1]] + v * surface.normals[corner[2]])
                                       .normalized();
    if (smooth.dot(normal) > sharp_cosine) normal = smooth;
  }
  const Eigen::Vector3f way(found.ray.dir_x, found.ray.dir_y, found.ray.dir_z);
  if (normal.dot(way) > 0) normal = -normal;
  return {Hit::Kind::collider, found.ray.tfar, normal};
}

std::optional<Hit> TracedScene::nearest(const Ray& ray) const {
  RTCRayHit found{};
  found.ray = to_embree(ray);
  found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  found.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  RayContext context(RayFrame(ray.origin, ray.direction), 0);
  rtcIntersect1(scene_, &context.context, &found);
  std::optional<Hit> hit;
  if (found.hit.geomID != RTC_INVALID_GEOMETRY_ID) {
    hit = hit_of(found);
  }
  for (const FlatPlane& plane : planes_) {
    const float approach = plane.normal.dot(ray.direction);
    if (!(approach < 0)) continue;
    const float distance = (plane.offset - plane.normal.dot(ray.origin)) / approach;
    if (distance < ray.from || distance > (hit ? hit->distance : ray.to)) continue;
    hit = Hit{Hit::Kind::plane, distance, plane.normal};
  }
  return hit;
}

bool TracedScene::is_shadowed(const Ray& ray, unsigned number) const {
  for (const FlatPlane& plane : planes_) {
    const float approach = plane.normal.dot(ray.direction);
    if (approach < 0 && plane.normal.dot(ray.origin) > plane.offset) return true;
  }
  RTCRay traced = to_embree(ray);
  RayContext context(RayFrame(ray.origin, ray.direction), number);
  rtcOccluded1(scene_, &context.context, &traced);
  return traced.tfar < 0;
}

}  // namespace ringlet
