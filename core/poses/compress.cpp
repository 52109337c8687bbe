// Squeezes the free part of a strand along its axis towards its anchor:
// x = x - fraction (axis . (x - x_anchor)) axis.
#include "core/pose.h"
#include "core/poses/free_part.h"
#include "core/registry.h"

namespace ringlet {
namespace {

struct Compress {
  double fraction = 0;

  static Schema<Compress> schema() {
    return Schema<Compress>().required("fraction", &Compress::fraction, "", between(0, 1),
                                       "part of its height that a strand loses");
  }
};

class CompressPose final : public Pose {
 public:
  explicit CompressPose(const Compress& compress) : fraction_(compress.fraction) {}

  void apply(const Strands& strands, const std::vector<int>& pinned_counts,
             std::vector<Eigen::Vector3d>& positions) const override {
    for (int strand = 0; strand < strands.count(); ++strand) {
      const auto part = free_part(strands, pinned_counts, strand);
      if (!part) continue;
      const Eigen::Vector3d axis = axis_of(strands, *part);
      const Eigen::Vector3d anchor = positions[part->anchor];
      for (int v = part->first; v < part->end; ++v) {
        positions[v] -= fraction_ * axis.dot(positions[v] - anchor) * axis;
      }
    }
  }

 private:
  double fraction_;
};

}  // namespace

void register_compress(Registry& registry) {
  registry.of<Pose>().add<Compress>(
      "compress",
      {"strands squeezed along their axis", "x = x - fraction (axis . (x - x_anchor)) axis",
       "Compression of Shi et al., Lifted Curls, SCA 2023"},
      [](const Compress& compress) { return std::make_unique<CompressPose>(compress); });
}

}  // namespace ringlet
