// Scales free vertices about the root of their strand: x = root + diag(factors) (x - root).
#include "core/pose.h"
#include "core/poses/free_part.h"
#include "core/registry.h"

namespace ringlet {
namespace {

struct Scale {
  Eigen::Vector3d factors = Eigen::Vector3d::Ones();

  static Schema<Scale> schema() {
    return Schema<Scale>().required("factors", &Scale::factors, "", any_number(),
                                    "along x, y and z");
  }
};

class ScalePose final : public Pose {
 public:
  explicit ScalePose(const Scale& scale) : factors_(scale.factors) {}

  void apply(const Strands& strands, const std::vector<int>& pinned_counts,
             std::vector<Eigen::Vector3d>& positions) const override {
    for (int strand = 0; strand < strands.count(); ++strand) {
      const auto part = free_part(strands, pinned_counts, strand);
      if (!part) continue;
      const Eigen::Vector3d root = positions[part->root];
      for (int v = part->first; v < part->end; ++v) {
        positions[v] = root + factors_.cwiseProduct(positions[v] - root);
      }
    }
  }

 private:
  Eigen::Vector3d factors_;
};

}  // namespace

void register_scale(Registry& registry) {
  registry.of<Pose>().add<Scale>(
      "scale",
      {"strands scaled about their root", "x = root + diag(factors) (x - root)",
       "Smash of Shi et al., Lifted Curls, SCA 2023"},
      [](const Scale& scale) { return std::make_unique<ScalePose>(scale); });
}

}  // namespace ringlet
