#include "core/sources/rooted_strands.h"

#include <Eigen/Geometry>
#include <cstdint>
#include <limits>
#include <numbers>

#include "core/random.h"

namespace ringlet {
namespace {

constexpr unsigned turn_stream = 1;  // another stream of random numbers than that of the roots

void check_counts(RootedStrands& strands, const std::string& pointer, ParseContext& context) {
  if (std::int64_t{strands.count} * strands.vertices > std::numeric_limits<int>::max()) {
    context.problem(pointer_to(pointer, "count"),
                    "expected fewer than 2^31 vertices in all, found " +
                        std::to_string(strands.count) + " strands of " +
                        std::to_string(strands.vertices));
  }
  if (strands.pinned > strands.vertices) {
    context.problem(pointer_to(pointer, "pinned"),
                    "expected at most the " + std::to_string(strands.vertices) +
                        " vertices of a strand, found " + std::to_string(strands.pinned));
  }
}

}  // namespace

Schema<RootedStrands> RootedStrands::schema() {
  return Schema<RootedStrands>()
      .key("count", &RootedStrands::count, "", between(1, 1e8), "number of strands")
      .key("vertices", &RootedStrands::vertices, "", at_least(2), "vertices of each strand")
      .key("roots", &RootedStrands::roots, "", any_number(), "where the strands stand")
      .key("pinned", &RootedStrands::pinned, "", at_least(0),
           "vertices of each strand, from the root, that are held; two hold its direction too")
      .key("motion", &RootedStrands::motion, "", any_number(),
           "name of the motion that the pinned vertices follow; empty: they rest")
      .key("seed", &RootedStrands::seed, "", at_least(0), "of the random numbers")
      .check(check_counts);
}

StrandSet grow_strands(const RootedStrands& strands, std::span<const Eigen::Vector3d> shape,
                       Turn turn) {
  const auto seed = static_cast<unsigned>(strands.seed);
  const auto source = strands.roots.make();
  const auto roots = naming(*source, [&] { return source->place(strands.count, seed); });
  Random random(seed, turn_stream);
  StrandSet set;
  set.vertex_counts.assign(roots.size(), static_cast<int>(shape.size()));
  set.pinned_counts.assign(roots.size(), strands.pinned);
  set.motions.assign(roots.size(), strands.motion.name);
  set.positions.reserve(roots.size() * shape.size());
  for (const Root& root : roots) {
    const double angle = turn == Turn::random ? random.uniform(0, 2 * std::numbers::pi) : 0.0;
    const Eigen::Quaterniond rotation =
        Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitY(), root.direction) *
        Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY());
    for (const Eigen::Vector3d& vertex : shape) {
      set.positions.push_back(root.position + rotation * vertex);
    }
  }
  return set;
}

}  // namespace ringlet
