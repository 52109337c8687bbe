#include "collision/continuous_detection.h"

#include <algorithm>

#include "collision/continuous.h"
#include "core/parallel.h"

namespace ringlet {
namespace {

double free_part_of_pair(const EdgePair& pair, std::span<const Eigen::Vector3d> from,
                         std::span<const Eigen::Vector3d> to, const KeptGap& kept) {
  const auto vertices_of = [&](std::span<const Eigen::Vector3d> at) {
    return std::array{at[pair.first], at[pair.first + 1], at[pair.second], at[pair.second + 1]};
  };
  return free_part_of_segments(vertices_of(from), vertices_of(to), kept);
}

}  // namespace

std::vector<EdgePair> ContinuousDetection::find_crossings(std::span<const Eigen::Vector3d> from,
                                                          std::span<const Eigen::Vector3d> to) {
  std::vector<EdgePair> pairs = find(from, to, 0);
  std::vector<char> crosses(pairs.size());
  parallel_for_each(static_cast<int>(pairs.size()), [&](int p) {
    crosses[p] = free_part_of_pair(pairs[p], from, to, {vanishing}) < 1 ? 1 : 0;
  });
  std::size_t kept = 0;
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    if (crosses[p] != 0) pairs[kept++] = pairs[p];
  }
  pairs.resize(kept);
  return pairs;
}

double free_part_of_pairs(std::span<const EdgePair> pairs, std::span<const double> thickness,
                          std::span<const Eigen::Vector3d> from,
                          std::span<const Eigen::Vector3d> to, double kept_part) {
  std::vector<double> parts(pairs.size() + 1, 1.0);
  parallel_for_each(static_cast<int>(pairs.size()), [&](int p) {
    if (thickness[p] > 0)
      parts[p] = free_part_of_pair(pairs[p], from, to, {kept_part, thickness[p]});
  });
  return *std::min_element(parts.begin(), parts.end());
}

}  // namespace ringlet
