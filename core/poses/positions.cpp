// Free vertices start where the scene says.
#include <string>

#include "core/pose.h"
#include "core/poses/free_part.h"
#include "core/registry.h"

namespace ringlet {
namespace {

struct Positions {
  std::vector<std::vector<Eigen::Vector3d>> strands;

  static Schema<Positions> schema() {
    return Schema<Positions>().required(
        "strands", &Positions::strands, "m", any_number(),
        "where the vertices of each strand start, those of pinned ones are ignored");
  }
};

void check_counts(const Strands& strands, const std::vector<std::vector<Eigen::Vector3d>>& given) {
  if (static_cast<int>(given.size()) != strands.count()) {
    throw Error("expected the positions of " + std::to_string(strands.count()) +
                " strands, found those of " + std::to_string(given.size()));
  }
  for (int strand = 0; strand < strands.count(); ++strand) {
    if (static_cast<int>(given[strand].size()) == strands.size(strand)) continue;
    throw Error("strand " + std::to_string(strand) + ": expected " +
                std::to_string(strands.size(strand)) + " positions, found " +
                std::to_string(given[strand].size()));
  }
}

class PositionsPose final : public Pose {
 public:
  explicit PositionsPose(const Positions& given) : strands_(given.strands) {}

  void apply(const Strands& strands, const std::vector<int>& pinned_counts,
             std::vector<Eigen::Vector3d>& positions) const override {
    check_counts(strands, strands_);
    for (int strand = 0; strand < strands.count(); ++strand) {
      const auto part = free_part(strands, pinned_counts, strand);
      if (!part) continue;
      for (int v = part->first; v < part->end; ++v) {
        positions[v] = strands_[strand][v - strands.first(strand)];
      }
    }
  }

 private:
  std::vector<std::vector<Eigen::Vector3d>> strands_;
};

}  // namespace

void register_positions(Registry& registry) {
  registry.of<Pose>().add<Positions>(
      "positions", {"free vertices where the scene says", "", ""},
      [](const Positions& given) { return std::make_unique<PositionsPose>(given); });
}

}  // namespace ringlet
