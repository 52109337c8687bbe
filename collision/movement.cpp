#include "collision/movement.h"

#include <algorithm>
#include <atomic>

#include "core/parallel.h"

namespace ringlet {
namespace {

/// A rigid motion is sought from about so many of the points.
constexpr std::size_t sample_size = 500;
/// Points that one thread looks at in one go.
constexpr std::size_t part_size = 2048;

}  // namespace

void Movement::start_from(std::span<const Eigen::Vector3d> positions) {
  start_.assign(positions.begin(), positions.end());
}

Eigen::Isometry3d Movement::rigid_part(std::span<const Eigen::Vector3d> positions) const {
  const std::size_t stride = std::max<std::size_t>(1, positions.size() / sample_size);
  const auto count = static_cast<Eigen::Index>((positions.size() + stride - 1) / stride);
  Eigen::Matrix3Xd from(3, count), to(3, count);
  for (Eigen::Index n = 0; n < count; ++n) {
    from.col(n) = start_[n * stride];
    to.col(n) = positions[n * stride];
  }
  return Eigen::Isometry3d(Eigen::umeyama(from, to, false));
}

template <class Body>
void Movement::for_each_stretch(const Body& body) const {
  const std::size_t parts = (start_.size() + part_size - 1) / part_size;
  parallel_for_each(static_cast<int>(parts), [&](int part) {
    const std::size_t begin = part * part_size;
    body(begin, std::min(begin + part_size, start_.size()));
  });
}

bool Movement::is_within(double distance, std::span<const Eigen::Vector3d> positions,
                         const Eigen::Isometry3d& motion) const {
  std::atomic<bool> within = true;
  for_each_stretch([&](std::size_t begin, std::size_t end) {
    bool all = true;
    for (std::size_t v = begin; v < end; ++v) {
      all &= (positions[v] - motion * start_[v]).squaredNorm() <= distance * distance;
    }
    if (!all) within = false;
  });
  return within;
}

std::vector<int> Movement::beyond(double distance, std::span<const Eigen::Vector3d> positions,
                                  const Eigen::Isometry3d& motion) const {
  std::vector<char> is_beyond(positions.size());
  for_each_stretch([&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      // True of what is not a number, too.
      is_beyond[v] = !((positions[v] - motion * start_[v]).squaredNorm() <= distance * distance);
    }
  });
  std::vector<int> points;
  for (std::size_t v = 0; v < is_beyond.size(); ++v) {
    if (is_beyond[v] != 0) points.push_back(static_cast<int>(v));
  }
  return points;
}

void Movement::restart(std::span<const int> points, std::span<const Eigen::Vector3d> positions,
                       const Eigen::Isometry3d& motion) {
  const Eigen::Isometry3d back = motion.inverse();
  for (const int point : points) start_[point] = back * positions[point];
}

void bring_to(std::span<const Eigen::Vector3d> end, std::vector<Eigen::Vector3d>& start) {
  Movement movement;
  movement.start_from(start);
  const Eigen::Isometry3d common = movement.rigid_part(end);
  for (auto& p : start) p = common * p;
}

}  // namespace ringlet
