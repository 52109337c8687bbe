#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/integrator.h"
#include "core/model.h"
#include "core/parameters.h"
#include "core/registry.h"

namespace ringlet {

/// A function of one vertex.
struct PointValue {
  double value;
  Eigen::Vector3d gradient;
  Eigen::Matrix3d hessian;
};

/// The sum of a function over all vertices; a force, or a term of one.
class PointTerm {
 public:
  using Function = std::function<PointValue(int vertex, const Eigen::Vector3d&)>;
  explicit PointTerm(Function function) : function_(std::move(function)) {}
  void bind(const StrandGroups& groups) { groups_ = &groups; }
  double add(int group, std::span<const Vector3<Pack>> x, GroupOutputs outputs) const;

 private:
  Function function_;
  const StrandGroups* groups_ = nullptr;
};

class PointForce final : public Force {
 public:
  explicit PointForce(PointTerm::Function function) : term_(std::move(function)) {}
  void bind(const Strands&, const StrandGroups& groups) override { term_.bind(groups); }
  void begin_step(const StepStart&) override {}
  double add(int group, std::span<const Vector3<Pack>> x, GroupOutputs outputs) const override {
    return term_.add(group, x, outputs);
  }

 private:
  PointTerm term_;
};

/// Gravity: minus m g . x.
class Weight final : public Force {
 public:
  /// It may claim a Hessian, which is zero.
  explicit Weight(const Eigen::Vector3d& acceleration, bool claims_hessian = false)
      : acceleration_(acceleration), claims_hessian_(claims_hessian) {}
  bool has_hessian() const override { return claims_hessian_; }
  void bind(const Strands& strands, const StrandGroups& groups) override;
  void begin_step(const StepStart&) override {}
  double add(int group, std::span<const Vector3<Pack>> x, GroupOutputs outputs) const override {
    return term_->add(group, x, outputs);
  }

 private:
  Eigen::Vector3d acceleration_;
  bool claims_hessian_;
  std::unique_ptr<PointTerm> term_;
};

/// k |x_{i+1} - x_i - d|^2 / 2 over all edges, d being the edge at rest: quadratic.
class Springs final : public Energy {
 public:
  explicit Springs(double stiffness) : stiffness_(stiffness) {}
  void bind(const Strands& strands, const StrandGroups& groups) override;
  double add(int group, std::span<const Vector3<Pack>> x, EdgeOutputs outputs) const override;

 private:
  double stiffness_;
  const StrandGroups* groups_ = nullptr;
  std::vector<Pack> edge_stiffness_;
  VertexField rest_;
};

/// A model of straight strands, the root of each pinned or not, solved by strand_cholesky.
std::unique_ptr<Model> make_model(const std::vector<int>& vertex_counts, bool pin_roots);
void add_energy(Model& model, std::unique_ptr<Energy> energy);
void add_force(Model& model, std::unique_ptr<Force> force);
/// At rest in the rest shape.
State rest_state(const Model& model);

std::unique_ptr<Integrator> make_integrator(const Json& json, const Model& model);
/// One of a registry, which may have more than those of ringlet.
std::unique_ptr<Integrator> make_integrator(const Registry& registry, const Json& json,
                                            const Model& model);

}  // namespace ringlet
