// A swing to and fro: with s = sin(2 pi frequency (t - start) + phase) - sin(phase), a rotation by
// s angle about the axis through the centre, then a translation by s translation. Rest before
// start; held as it is at end after it. sin(phase) is taken off so that the motion starts from rest
// without a jump.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/direction.h"
#include "core/motion.h"
#include "core/registry.h"

namespace ringlet {
namespace {

struct Sinusoid {
  double frequency = 1;
  double angle = 0;
  Direction axis;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  double phase = 0;
  double start = 0;
  std::optional<double> end;

  static Schema<Sinusoid> schema();
};

void check_sinusoid(Sinusoid& motion, const std::string& pointer, ParseContext& context) {
  if (motion.end && *motion.end <= motion.start) {
    context.problem(pointer_to(pointer, "end"), "expected a time after start, " +
                                                    Json(motion.start).dump() + " s, found " +
                                                    Json(*motion.end).dump());
  }
  if (motion.angle == 0 && motion.translation.isZero(0)) {
    context.problem(pointer, "expected an angle or a translation: this motion moves nothing");
  }
}

Schema<Sinusoid> Sinusoid::schema() {
  return Schema<Sinusoid>()
      .required("frequency", &Sinusoid::frequency, "Hz", positive(), "of the swing")
      .key("angle", &Sinusoid::angle, "rad", any_number(), "amplitude of the rotation")
      .key("axis", &Sinusoid::axis, "", any_number(), "of the rotation")
      .key("centre", &Sinusoid::centre, "m", any_number(), "point that the axis passes through")
      .key("translation", &Sinusoid::translation, "m", any_number(),
           "amplitude of the translation, a vector")
      .key("phase", &Sinusoid::phase, "rad", any_number(), "of the swing at start")
      .key("start", &Sinusoid::start, "s", any_number(), "time before which the motion rests")
      .key("end", &Sinusoid::end, "s", any_number(),
           "time after which the motion is held; never if absent")
      .check(check_sinusoid);
}

class SinusoidMotion final : public Motion {
 public:
  explicit SinusoidMotion(const Sinusoid& swing) : swing_(swing) {}

  Eigen::Isometry3d at(double time) const override {
    const double end = swing_.end ? std::min(time, *swing_.end) : time;
    const double since_start = std::max(end - swing_.start, 0.0);
    const double s =
        std::sin(2 * std::numbers::pi * swing_.frequency * since_start + swing_.phase) -
        std::sin(swing_.phase);
    return Eigen::Translation3d(swing_.centre + s * swing_.translation) *
           Eigen::AngleAxisd(s * swing_.angle, swing_.axis.unit) *
           Eigen::Translation3d(-swing_.centre);
  }

 private:
  Sinusoid swing_;
};

}  // namespace

void register_sinusoid(Registry& registry) {
  registry.of<Motion>().add<Sinusoid>(
      "sinusoid",
      {"a rotation and translation to and fro",
       "s = sin(2 pi frequency (t - start) + phase) - sin(phase)", ""},
      [](const Sinusoid& swing) { return std::make_unique<SinusoidMotion>(swing); });
}

}  // namespace ringlet
