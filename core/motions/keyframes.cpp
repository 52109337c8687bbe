// A motion through given placements: translations are interpolated linearly, rotations at constant
// speed along the shorter way (slerp), so that neighbouring keys should be less than half a turn
// apart. Held outside the keys. A key with rotation R and translation d takes p to
// centre + R (p - centre) + d.
#include <algorithm>

#include "core/motion.h"
#include "core/registry.h"

namespace ringlet {
namespace {

struct Keyframes {
  std::vector<double> times;
  std::vector<Eigen::Vector3d> translations;
  std::vector<Eigen::Vector3d> rotations;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();

  static Schema<Keyframes> schema();
};

void check_keyframes(Keyframes& keys, const std::string& pointer, ParseContext& context) {
  if (keys.times.empty()) {
    context.problem(pointer_to(pointer, "times"), "expected at least one time");
  }
  for (std::size_t i = 1; i < keys.times.size(); ++i) {
    if (keys.times[i] > keys.times[i - 1]) continue;
    context.problem(pointer_to(pointer_to(pointer, "times"), i),
                    "expected a time after the one before it, " + Json(keys.times[i - 1]).dump() +
                        " s, found " + Json(keys.times[i]).dump());
  }
  const auto same_length = [&](const std::vector<Eigen::Vector3d>& list, const char* name) {
    if (list.empty() || list.size() == keys.times.size()) return;
    context.problem(pointer_to(pointer, name),
                    "expected one entry for each of the " + std::to_string(keys.times.size()) +
                        " times, or none at all, found " + std::to_string(list.size()));
  };
  same_length(keys.translations, "translations");
  same_length(keys.rotations, "rotations");
  if (keys.translations.empty() && keys.rotations.empty()) {
    context.problem(pointer, "expected translations or rotations: this motion moves nothing");
  }
}

Schema<Keyframes> Keyframes::schema() {
  return Schema<Keyframes>()
      .required("times", &Keyframes::times, "s", any_number(), "of the keys, increasing")
      .key("translations", &Keyframes::translations, "m", any_number(),
           "at each time; none if absent")
      .key("rotations", &Keyframes::rotations, "rad", any_number(),
           "at each time, as axis times angle; none if absent")
      .key("centre", &Keyframes::centre, "m", any_number(), "of the rotations")
      .check(check_keyframes);
}

Eigen::Quaterniond rotation_by(const Eigen::Vector3d& axis_times_angle) {
  return Eigen::Quaterniond(
      Eigen::AngleAxisd(axis_times_angle.stableNorm(), axis_times_angle.stableNormalized()));
}

class KeyframeMotion final : public Motion {
 public:
  explicit KeyframeMotion(const Keyframes& keys) : keys_(keys) {}

  Eigen::Isometry3d at(double time) const override {
    const auto& times = keys_.times;
    const auto after = static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), time) -
                                                times.begin());
    const std::size_t from = after == 0 ? 0 : after - 1;
    const std::size_t to = std::min(after, times.size() - 1);
    const double part = from == to ? 0.0 : (time - times[from]) / (times[to] - times[from]);

    Eigen::Isometry3d placement = Eigen::Isometry3d::Identity();
    if (!keys_.translations.empty()) {
      placement.translate((1 - part) * keys_.translations[from] + part * keys_.translations[to]);
    }
    placement.translate(keys_.centre);
    if (!keys_.rotations.empty()) {
      placement.rotate(
          rotation_by(keys_.rotations[from]).slerp(part, rotation_by(keys_.rotations[to])));
    }
    placement.translate(-keys_.centre);
    return placement;
  }

 private:
  Keyframes keys_;
};

}  // namespace

void register_keyframes(Registry& registry) {
  registry.of<Motion>().add<Keyframes>(
      "keyframes",
      {"a motion through given placements", "p -> centre + R(t) (p - centre) + d(t)", ""},
      [](const Keyframes& keys) { return std::make_unique<KeyframeMotion>(keys); });
}

}  // namespace ringlet
