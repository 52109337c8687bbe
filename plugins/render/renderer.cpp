#include "plugins/render/renderer.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "plugins/render/colour.h"
#include "plugins/render/hash.h"
#include "plugins/render/lighting.h"

namespace ringlet {

void require_renderer() {}

namespace {

/// A number in (-1, 1) with a density that is a tent, which is the filter of the picture.
float tent(float u) { return u < 0.5F ? std::sqrt(2 * u) - 1 : 1 - std::sqrt(2 - 2 * u); }

class Painter {
 public:
  Painter(const Lighting& lighting, const Camera& camera, const Eigen::Vector3d& origin,
          const RenderParameters& parameters)
      : lighting_(lighting),
        camera_(camera),
        eye_((camera.position() - origin).cast<float>()),
        samples_(parameters.samples),
        exposure_(static_cast<float>(parameters.exposure)) {}

  void paint_row(int y, std::uint8_t* bytes) const {
    for (int x = 0; x < camera_.width(); ++x) {
      const Rgb colour = tone_mapped(exposure_ * light_of(x, y));
      for (const float c : colour) *bytes++ = to_srgb_byte(c);
    }
  }

 private:
  Rgb light_of(int x, int y) const {
    const auto pixel = static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(camera_.width()) +
                       static_cast<std::uint64_t>(x);
    const SamplePattern pattern(pixel);
    Rgb sum = Rgb::Zero();
    for (int i = 0; i < samples_; ++i) {
      const double across = x + 0.5 + tent(pattern(i, in_pixel));
      const double down = y + 0.5 + tent(pattern(i, in_pixel + 1));
      const Ray ray{eye_, camera_.direction_through(across, down).cast<float>()};
      const auto seed = static_cast<unsigned>(mix_bits(pixel) + 2 * static_cast<std::uint64_t>(i));
      // A single light that happens to be very strong must not make a speck.
      sum += lighting_.arriving(ray, {pattern, i, seed}).min(brightest);
    }
    return sum / static_cast<float>(samples_);
  }

  static constexpr float brightest = 4;
  const Lighting& lighting_;
  const Camera& camera_;
  Eigen::Vector3f eye_;
  int samples_;
  float exposure_;
};

}  // namespace

Picture draw(const DrawnScene& subject, const Camera& camera, const Eigen::Vector3d& up,
             const RenderParameters& parameters) {
  // What is far from the origin of the scene would be coarse in single precision.
  const Eigen::Vector3d origin = subject.strands.positions.cols() > 0
                                     ? Eigen::Vector3d(subject.strands.positions.rowwise().mean())
                                     : Eigen::Vector3d::Zero();
  const bool has_children = parameters.children > 0;
  const ChildParameters children{parameters.children, parameters.child_radius, parameters.spread,
                                 parameters.frizz, parameters.strays};
  const TracedScene scene(
      has_children ? Curves() : make_curves(subject.strands, origin),
      has_children ? make_bundles(subject.strands, children, origin) : Bundles(),
      HairShading(parameters).transmitted(), subject.shapes, origin);
  const Lighting lighting(scene, parameters, up);
  const Painter painter(lighting, camera, origin, parameters);
  Picture picture{camera.width(), camera.height(), {}};
  const std::size_t row = 3 * static_cast<std::size_t>(camera.width());
  picture.bytes.resize(row * static_cast<std::size_t>(camera.height()));
  parallel_for_each(camera.height(), [&](int y) {
    painter.paint_row(y, &picture.bytes[row * static_cast<std::size_t>(y)]);
  });
  return picture;
}

}  // namespace ringlet
