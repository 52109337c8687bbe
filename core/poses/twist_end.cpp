// Turns the last vertex of each strand by an angle about the edge that ends at the vertex before
// it. Strands of fewer than three vertices have no such edge, and stay.
#include <Eigen/Geometry>
#include <numbers>

#include "core/pose.h"
#include "core/poses/free_part.h"
#include "core/registry.h"

namespace ringlet {
namespace {

struct TwistEnd {
  double angle = std::numbers::pi / 4;

  static Schema<TwistEnd> schema() {
    return Schema<TwistEnd>().key("angle", &TwistEnd::angle, "rad", any_number(),
                                  "by which the last vertex is turned");
  }
};

class TwistEndPose final : public Pose {
 public:
  explicit TwistEndPose(const TwistEnd& twist) : angle_(twist.angle) {}

  void apply(const Strands& strands, const std::vector<int>& pinned_counts,
             std::vector<Eigen::Vector3d>& positions) const override {
    for (int strand = 0; strand < strands.count(); ++strand) {
      const auto part = free_part(strands, pinned_counts, strand);
      if (!part || strands.size(strand) < 3) continue;
      const int tip = part->end - 1;
      const Eigen::Vector3d centre = positions[tip - 1];
      const Eigen::Vector3d edge = (centre - positions[tip - 2]).stableNormalized();
      positions[tip] = centre + Eigen::AngleAxisd(angle_, edge) * (positions[tip] - centre);
    }
  }

 private:
  double angle_;
};

}  // namespace

void register_twist_end(Registry& registry) {
  registry.of<Pose>().add<TwistEnd>(
      "twist_end",
      {"last vertex of each strand turned about the edge before it", "",
       "End tweak of Shi et al., Lifted Curls, SCA 2023"},
      [](const TwistEnd& twist) { return std::make_unique<TwistEndPose>(twist); });
}

}  // namespace ringlet
