#pragma once

#include "tests/solvers/test_model.h"

namespace ringlet {

/// A resistance of every vertex: -c m v, with v as the integrator says.
class Resistance final : public Force {
 public:
  explicit Resistance(double coefficient) : coefficient_(coefficient) {}
  void bind(const Strands& strands, const StrandGroups& groups) override {
    strands_ = &strands;
    term_.bind(groups);
  }
  void begin_step(const StepStart& start) override {
    origin_ = start.velocity.origin;
    interval_ = start.velocity.interval;
  }
  double add(int group, std::span<const Vector3<Pack>> x, GroupOutputs outputs) const override {
    return term_.add(group, x, outputs);
  }

 private:
  PointValue at(int vertex, const Eigen::Vector3d& x) const {
    const double c = coefficient_ * strands_->mass(vertex);
    const Eigen::Vector3d v = (x - origin_.get(vertex)) / interval_;
    return {0.5 * interval_ * c * v.squaredNorm(), c * v,
            c / interval_ * Eigen::Matrix3d::Identity()};
  }

  double coefficient_;
  const Strands* strands_ = nullptr;
  PointTerm term_{[this](int vertex, const Eigen::Vector3d& x) { return at(vertex, x); }};
  VertexField origin_;
  double interval_ = 1;
};

/// A quartic well about the rest position of every vertex, as stiff as its mass.
inline std::unique_ptr<Force> make_well(const Model& model, double strength) {
  return std::make_unique<PointForce>([&model, strength](int vertex, const Eigen::Vector3d& x) {
    const Eigen::Vector3d d = x - model.strands.rest_position(vertex);
    const double k = strength * model.strands.mass(vertex);
    return PointValue{k / 4 * d.squaredNorm() * d.squaredNorm(), k * d.squaredNorm() * d,
                      k * (d.squaredNorm() * Eigen::Matrix3d::Identity() + 2 * d * d.transpose())};
  });
}

/// Two strands whose roots are pinned, bound by springs, resisted, and in a nonlinear well.
inline std::unique_ptr<Model> make_lively_model(double resistance) {
  auto model = make_model({4, 7}, true);
  add_energy(*model, std::make_unique<Springs>(200 * model->strands.mass(1)));
  add_force(*model, std::make_unique<Weight>(Eigen::Vector3d(0, -9.81, 0)));
  add_force(*model, std::make_unique<Resistance>(resistance));
  add_force(*model, make_well(*model, 5));
  return model;
}

/// At rest, thrown.
inline State thrown_state(const Model& model) {
  State state = rest_state(model);
  for (int v = 0; v < model.strands.vertex_count(); ++v) {
    const bool is_pinned = v == model.strands.first(model.strands.strand_of(v));
    if (!is_pinned) state.velocities.set(v, {std::sin(v), 1, std::cos(3 * v)});
  }
  return state;
}

}  // namespace ringlet
