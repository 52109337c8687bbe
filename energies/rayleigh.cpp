// Rayleigh damping: a force -D v with D = alpha M + beta K(x_n), where M are the masses and K is
// the filtered Hessian of the elastic energies at the start of the step. Over a step with
// v = (x - o) / h at its end (core/step_start.h) it comes from the incremental potential h/2 v . D
// v (math.md, section 6).

#include "core/force.h"
#include "core/parallel.h"
#include "core/registry.h"
#include "core/vertex_scalars.h"

namespace ringlet {

namespace {

struct RayleighParameters {
  double mass = 0;
  double stiffness = 0;

  static Schema<RayleighParameters> schema() {
    return Schema<RayleighParameters>()
        .key("mass", &RayleighParameters::mass, "1/s", at_least(0),
             "alpha: damping proportional to mass, damps slow motion most")
        .key("stiffness", &RayleighParameters::stiffness, "s", at_least(0),
             "beta: damping proportional to elastic stiffness, damps fast motion most");
  }
};

class Rayleigh final : public Force {
 public:
  explicit Rayleigh(const RayleighParameters& parameters) : parameters_(parameters) {}

  void bind(const Strands& strands, const StrandGroups& groups) override {
    groups_ = &groups;
    mass_ =
        vertex_scalars(groups, [&](int vertex) { return parameters_.mass * strands.mass(vertex); });
    if (uses_stiffness()) stiffness_ = StrandBands(groups);
  }

  bool vanishes() const override { return parameters_.mass == 0 && parameters_.stiffness == 0; }
  std::size_t bytes() const override {
    return bytes_of(mass_) + stiffness_.bytes() + origin_.bytes();
  }
  void begin_step(const StepStart& start) override {
    origin_ = start.velocity.origin;
    interval_ = start.velocity.interval;
    if (!uses_stiffness()) return;
    parallel_for_each(groups_->count(), [&](int g) {
      const GroupBands bands = stiffness_.group(g);
      std::fill(bands.blocks().begin(), bands.blocks().end(), Matrix3<Pack>::zero());
      for (const auto& energy : start.energies) {
        add_at_vertices(*energy, g, start.state.positions.group(g), {{}, bands});
      }
      for (Matrix3<Pack>& block : bands.blocks()) block = Pack(parameters_.stiffness) * block;
    });
  }

  double add(int group, std::span<const Vector3<Pack>> x, GroupOutputs outputs) const override {
    const Pack* mass = &mass_[(*groups_)[group].first_row];
    const std::span origin = origin_.group(group);
    const Pack inverse_interval = 1 / interval_;
    std::vector<Vector3<Pack>> v(x.size()), damping(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      v[i] = inverse_interval * (x[i] - origin[i]);
      damping[i] = mass[i] * v[i];
    }
    if (uses_stiffness()) add_band_product(stiffness_, group, v, damping);
    Pack energy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      energy += 0.5 * interval_ * dot(v[i], damping[i]);
      if (!outputs.gradient.empty()) outputs.gradient[i] += damping[i];
    }
    if (!outputs.hessian.empty()) add_hessian(group, inverse_interval, outputs.hessian);
    return sum_lanes(energy);
  }

 private:
  bool uses_stiffness() const { return parameters_.stiffness > 0; }

  void add_hessian(int group, const Pack& inverse_interval, const GroupBands& hessian) const {
    const int first_row = (*groups_)[group].first_row;
    for (int i = 0; i < hessian.rows(); ++i) {
      const Pack mass = inverse_interval * mass_[first_row + i];
      for (int c = 0; c < 3; ++c) hessian.block(i, 0)(c, c) += mass;
      if (!uses_stiffness()) continue;
      for (int k = 0; k <= std::min(i, band_blocks - 1); ++k) {
        hessian.block(i, k) += inverse_interval * stiffness_.block(first_row + i, k);
      }
    }
  }

  RayleighParameters parameters_;
  const StrandGroups* groups_ = nullptr;
  VertexScalars mass_;     ///< alpha m, 0 on pads
  StrandBands stiffness_;  ///< beta K(x_n); empty if beta is 0
  VertexField origin_;
  double interval_ = 1;
};

}  // namespace

void register_rayleigh(Registry& registry);
void register_rayleigh(Registry& registry) {
  registry.of<Force>().add<RayleighParameters>(
      "rayleigh",
      {"damping proportional to mass and to elastic stiffness",
       "-(alpha M + beta K(x_n)) v, K the filtered Hessian of the energies", "math.md, section 6"},
      [](const RayleighParameters& parameters) { return std::make_unique<Rayleigh>(parameters); });
}

}  // namespace ringlet
