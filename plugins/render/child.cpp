#include "plugins/render/child.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plugins/render/hash.h"

namespace ringlet {
namespace {

/// Children end at this part of the strand or later.
constexpr double shortest = 0.85;
/// Strays are up to this many times as far from the strand as others.
constexpr double farthest_stray = 4;
/// Lengths of the waves of the frizz, in radii of the strand.
constexpr double shortest_wave = 8, longest_wave = 32;

/// How much the phase of the common waves changes from the middle of a bundle to its edge, rad.
constexpr double phase_across = 2;
/// The part of the frizz that neighbours do not share.
constexpr double own_part = 0.2;

Eigen::Vector2d at_angle(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// Numbers that are drawn for a strand and one of its children, or for all of them.
class Draws {
 public:
  static constexpr int all_children = -1;
  Draws(int strand, int child)
      : strand_(static_cast<std::uint64_t>(strand)), child_(static_cast<std::uint64_t>(child)) {}
  double operator()() { return hashed_uniform(strand_, child_, drawn_++); }
  double angle() { return 2 * std::numbers::pi * (*this)(); }
  /// By what a wave turns along an edge.
  Eigen::Vector2d turn(const Guide& guide) {
    const double unit = std::max(guide.mean_radius(), 1e-9);
    const double length = unit * (shortest_wave + (longest_wave - shortest_wave) * (*this)());
    return at_angle(2 * std::numbers::pi * guide.mean_edge() / length);
  }

 private:
  std::uint64_t strand_, child_, drawn_ = 0;
};

}  // namespace

Child::Child(const Guide& guide, int number, const ChildParameters& parameters)
    : spread_(parameters.spread), frizz_(parameters.frizz) {
  Draws own(guide.strand(), number), common(guide.strand(), Draws::all_children);
  // The square root spreads children evenly over the disc.
  const double distance = std::sqrt(own());
  place_ = distance * at_angle(own.angle());
  const double shorter = own();
  end_ = (1 - (1 - shortest) * shorter * shorter) * (guide.count() - 1);
  const bool is_stray = own() < parameters.strays;
  if (is_stray) spread_ *= 1 + (farthest_stray - 1) * own();
  for (int wave = 0; wave < waves; ++wave) {
    const bool is_common = wave < common_waves;
    turn_[wave] = is_common ? common.turn(guide) : own.turn(guide);
    const double phase = is_common ? common.angle() : own.angle();
    const Eigen::Vector2d across = phase_across * at_angle(common.angle());
    now_[wave] = at_angle(phase + across.dot(place_));
  }
}

void Child::advance() {
  for (int wave = 0; wave < waves; ++wave) {
    const Eigen::Vector2d a = now_[wave], b = turn_[wave];
    now_[wave] = {a.x() * b.x() - a.y() * b.y(), a.x() * b.y() + a.y() * b.x()};
  }
}

Eigen::Vector2d Child::offset_now() const {
  const Eigen::Vector2d common{now_[0].y() + now_[1].y(), now_[2].y() + now_[3].y()};
  const Eigen::Vector2d own{now_[4].y(), now_[5].y()};
  // Each entry is at most 2, and so the length at most the square root of 8.
  const Eigen::Vector2d sum = (1 - own_part) * common + 2 * own_part * own;
  return (1 - frizz_) * place_ + frizz_ / std::sqrt(8.0) * sum;
}

}  // namespace ringlet
