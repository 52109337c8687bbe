// Linear air drag: a force -c l (v - w) on every vertex, with its Voronoi length l and the velocity
// w of the air. Over a step with v = (x - o) / h at its end (core/step_start.h) it comes from the
// incremental potential h/2 c l |v - w|^2.

#include "core/force.h"
#include "core/registry.h"
#include "core/vertex_scalars.h"

namespace ringlet {

namespace {

struct DragParameters {
  double coefficient = 1e-4;
  Eigen::Vector3d wind{0, 0, 0};

  static Schema<DragParameters> schema() {
    return Schema<DragParameters>()
        .key("coefficient", &DragParameters::coefficient, "N s/m^2", at_least(0),
             "drag force per length of strand and relative velocity")
        .key("wind", &DragParameters::wind, "m/s", any_number(), "velocity of the air");
  }
};

class Drag final : public Force {
 public:
  explicit Drag(const DragParameters& parameters) : parameters_(parameters) {}

  void bind(const Strands& strands, const StrandGroups& groups) override {
    groups_ = &groups;
    coefficient_ = vertex_scalars(groups, [&](int vertex) {
      return parameters_.coefficient * strands.voronoi_length(vertex);
    });
  }
  bool vanishes() const override { return parameters_.coefficient == 0; }
  std::size_t bytes() const override { return bytes_of(coefficient_) + origin_.bytes(); }
  void begin_step(const StepStart& start) override {
    origin_ = start.velocity.origin;
    interval_ = start.velocity.interval;
  }

  double add(int group, std::span<const Vector3<Pack>> x, GroupOutputs outputs) const override {
    const Pack* coefficient = &coefficient_[(*groups_)[group].first_row];
    const std::span origin = origin_.group(group);
    const Eigen::Vector3d& w = parameters_.wind;
    const Vector3<Pack> wind{w.x(), w.y(), w.z()};
    const Pack inverse_interval = 1 / interval_;
    Pack energy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Vector3<Pack> slip = inverse_interval * (x[i] - origin[i]) - wind;
      energy += 0.5 * interval_ * coefficient[i] * squared_norm(slip);
      if (!outputs.gradient.empty()) outputs.gradient[i] += coefficient[i] * slip;
      if (!outputs.hessian.empty()) {
        Matrix3<Pack>& block = outputs.hessian.block(static_cast<int>(i), 0);
        for (int c = 0; c < 3; ++c) block(c, c) += coefficient[i] * inverse_interval;
      }
    }
    return sum_lanes(energy);
  }

 private:
  DragParameters parameters_;
  const StrandGroups* groups_ = nullptr;
  VertexScalars coefficient_;  ///< N s/m, 0 on pads
  VertexField origin_;
  double interval_ = 1;
};

}  // namespace

void register_drag(Registry& registry);
void register_drag(Registry& registry) {
  registry.of<Force>().add<DragParameters>(
      "drag", {"linear air drag, with wind", "-c l (v - wind), l = Voronoi length", ""},
      [](const DragParameters& parameters) { return std::make_unique<Drag>(parameters); });
}

}  // namespace ringlet
