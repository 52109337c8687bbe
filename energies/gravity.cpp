// Uniform gravity: the potential -m g . x of every vertex.

#include "core/force.h"
#include "core/registry.h"
#include "core/vertex_scalars.h"

namespace ringlet {

namespace {

struct GravityParameters {
  Eigen::Vector3d acceleration{0, -9.81, 0};

  static Schema<GravityParameters> schema() {
    return Schema<GravityParameters>().key("acceleration", &GravityParameters::acceleration,
                                           "m/s^2", any_number(), "of everything free to fall");
  }
};

class Gravity final : public Force {
 public:
  explicit Gravity(const GravityParameters& parameters) : acceleration_(parameters.acceleration) {}

  void bind(const Strands& strands, const StrandGroups& groups) override {
    groups_ = &groups;
    mass_ = vertex_scalars(groups, [&](int vertex) { return strands.mass(vertex); });
  }
  bool vanishes() const override { return acceleration_.isZero(0); }
  bool has_hessian() const override { return false; }
  std::size_t bytes() const override { return bytes_of(mass_); }
  void begin_step(const StepStart&) override {}

  double add(int group, std::span<const Vector3<Pack>> x, GroupOutputs outputs) const override {
    const Pack* mass = &mass_[(*groups_)[group].first_row];
    const Vector3<Pack> g{acceleration_.x(), acceleration_.y(), acceleration_.z()};
    Pack energy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      energy -= mass[i] * dot(g, x[i]);
      if (!outputs.gradient.empty()) outputs.gradient[i] -= mass[i] * g;
    }
    return sum_lanes(energy);
  }

 private:
  Eigen::Vector3d acceleration_;
  const StrandGroups* groups_ = nullptr;
  VertexScalars mass_;  ///< 0 on pads
};

}  // namespace

void register_gravity(Registry& registry);
void register_gravity(Registry& registry) {
  registry.of<Force>().add<GravityParameters>(
      "gravity", {"uniform gravity", "-m g . x", ""},
      [](const GravityParameters& parameters) { return std::make_unique<Gravity>(parameters); });
}

}  // namespace ringlet
