// Moves every free vertex by a random offset, uniform in [-amplitude, amplitude] in each
// coordinate.
#include "core/pose.h"
#include "core/poses/free_part.h"
#include "core/random.h"
#include "core/registry.h"

namespace ringlet {
namespace {

struct Jitter {
  double amplitude = 0;
  int seed = 1;

  static Schema<Jitter> schema() {
    return Schema<Jitter>()
        .required("amplitude", &Jitter::amplitude, "m", at_least(0),
                  "largest offset in a coordinate")
        .key("seed", &Jitter::seed, "", at_least(0), "of the random numbers");
  }
};

class JitterPose final : public Pose {
 public:
  explicit JitterPose(const Jitter& jitter) : jitter_(jitter) {}

  void apply(const Strands& strands, const std::vector<int>& pinned_counts,
             std::vector<Eigen::Vector3d>& positions) const override {
    Random random(static_cast<unsigned>(jitter_.seed));
    for (int strand = 0; strand < strands.count(); ++strand) {
      const auto part = free_part(strands, pinned_counts, strand);
      if (!part) continue;
      for (int v = part->first; v < part->end; ++v) {
        for (double& coordinate : positions[v]) {
          coordinate += random.uniform(-jitter_.amplitude, jitter_.amplitude);
        }
      }
    }
  }

 private:
  Jitter jitter_;
};

}  // namespace

void register_jitter(Registry& registry) {
  registry.of<Pose>().add<Jitter>(
      "jitter",
      {"every free vertex moved at random", "x = x + amplitude (u, v, w), u, v, w in [-1, 1]",
       "Jitter of Shi et al., Lifted Curls, SCA 2023"},
      [](const Jitter& jitter) { return std::make_unique<JitterPose>(jitter); });
}

}  // namespace ringlet
