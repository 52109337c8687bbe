// A constant force at one vertex of each strand: the potential -f . x.

#include "core/force.h"
#include "core/registry.h"
#include "core/vertex_scalars.h"

namespace ringlet {

namespace {

struct PointForceParameters {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  int vertex = -1;

  static Schema<PointForceParameters> schema() {
    return Schema<PointForceParameters>()
        .required("force", &PointForceParameters::force, "N", any_number(), "at each strand")
        .key("vertex", &PointForceParameters::vertex, "", at_least(-1),
             "where it acts, counted from the root; -1: at the tip. Strands without such a vertex "
             "feel nothing");
  }
};

class PointForce final : public Force {
 public:
  explicit PointForce(const PointForceParameters& parameters) : parameters_(parameters) {}

  void bind(const Strands& strands, const StrandGroups& groups) override {
    groups_ = &groups;
    acts_ = vertex_scalars(groups, [&](int vertex) { return is_at(strands, vertex) ? 1.0 : 0.0; });
  }
  bool vanishes() const override { return parameters_.force.isZero(0); }
  bool has_hessian() const override { return false; }
  std::size_t bytes() const override { return bytes_of(acts_); }
  void begin_step(const StepStart&) override {}

  double add(int group, std::span<const Vector3<Pack>> x, GroupOutputs outputs) const override {
    const Pack* acts = &acts_[(*groups_)[group].first_row];
    const Eigen::Vector3d& force = parameters_.force;
    const Vector3<Pack> f{force.x(), force.y(), force.z()};
    Pack energy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      energy -= acts[i] * dot(f, x[i]);
      if (!outputs.gradient.empty()) outputs.gradient[i] -= acts[i] * f;
    }
    return sum_lanes(energy);
  }

 private:
  bool is_at(const Strands& strands, int vertex) const {
    const int strand = strands.strand_of(vertex);
    const int place = parameters_.vertex < 0 ? strands.size(strand) - 1 : parameters_.vertex;
    return vertex == strands.first(strand) + place;
  }

  PointForceParameters parameters_;
  const StrandGroups* groups_ = nullptr;
  VertexScalars acts_;  ///< 1 where the force acts, else 0
};

}  // namespace

void register_point_force(Registry& registry);
void register_point_force(Registry& registry) {
  registry.of<Force>().add<PointForceParameters>(
      "point_force", {"a constant force at one vertex of each strand", "-f . x", ""},
      [](const PointForceParameters& parameters) {
        return std::make_unique<PointForce>(parameters);
      });
}

}  // namespace ringlet
