#pragma once

#include <embree3/rtcore.h>

#include "plugins/render/bundle_tracing.h"

namespace ringlet {

/// What every ray takes along for bundles; Embree hands it on.
struct RayContext {
  RTCIntersectContext context;
  RayFrame frame;
  unsigned number;  ///< decides by chance which hairs a shadow ray goes through

  RayContext(const RayFrame& ray_frame, unsigned chance);
};

/// Bundles as a geometry of Embree's, whose rays must come with a RayContext.
class BundleGeometry {
 public:
  /// `transmitted` is the part of light that goes straight through a hair.
  BundleGeometry(Bundles bundles, float transmitted);
  /// The geometry refers to this.
  RTCGeometry make(RTCDevice device) const;

  /// What a hit is of.
  struct Hair {
    Eigen::Vector3f tangent;  ///< of length 1
    float radius;             ///< m
    std::uint64_t number;     ///< of the hair
  };
  Hair hair_of(const RTCHit& hit) const;
  bool is_empty() const { return bundles_.segments.empty(); }

 private:
  static void find_bounds(const RTCBoundsFunctionArguments* arguments);
  static void intersect(const RTCIntersectFunctionNArguments* arguments);
  static void occlude(const RTCOccludedFunctionNArguments* arguments);
  LaneHits trace_segment(const Bundles::Segment& segment, const RTCRay& ray,
                         const RayContext& context) const;
  bool is_beyond_tip(const Bundles::Segment& segment, int lane, float u) const;
  bool goes_through(const RayContext& context, std::uint64_t hair) const;

  float thickest(std::uint32_t point) const;

  Bundles bundles_;
  std::vector<Tube> tubes_;  // of the segments
  float transmitted_;
};

}  // namespace ringlet
