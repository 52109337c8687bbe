// Pulls the free part of a strand to a straight line along its axis, with edges at rest length:
// x_v = x_anchor + s_v axis, s_v the rest length of the strand from the anchor to vertex v.
#include "core/pose.h"
#include "core/poses/free_part.h"
#include "core/registry.h"

namespace ringlet {
namespace {

class StraightenPose final : public Pose {
 public:
  void apply(const Strands& strands, const std::vector<int>& pinned_counts,
             std::vector<Eigen::Vector3d>& positions) const override {
    for (int strand = 0; strand < strands.count(); ++strand) {
      const auto part = free_part(strands, pinned_counts, strand);
      if (!part) continue;
      const Eigen::Vector3d axis = axis_of(strands, *part);
      double length = 0;
      for (int v = part->anchor + 1; v < part->end; ++v) {
        length += strands.rest_length(v - 1);
        positions[v] = positions[part->anchor] + length * axis;
      }
    }
  }
};

}  // namespace

void register_straighten(Registry& registry) {
  registry.of<Pose>().add<NoParameters>(
      "straighten",
      {"strands pulled straight along their axis, at rest length", "x_v = x_anchor + s_v axis",
       "Straighten of Shi et al., Lifted Curls, SCA 2023"},
      [](const NoParameters&) { return std::make_unique<StraightenPose>(); });
}

}  // namespace ringlet
