#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/collision_stage.h"
#include "core/coupling_energy.h"
#include "core/energy.h"
#include "core/force.h"
#include "core/linear_solver.h"
#include "core/motion.h"
#include "core/strand_groups.h"
#include "core/strands.h"

namespace ringlet {

/// A term that a scene names, and that is zero wherever the strands are.
struct LeftOut {
  std::string kind, name;
};

/// What the rest state of a scene holds of the loads on the strands' shape, and what it does not.
struct RestReport {
  int strands = 0;          ///< that are free to move
  int not_held = 0;         ///< of them: that start with a thousandth of the largest load or more
  double acceleration = 0;  ///< of the vertex that starts to move most, m/s^2
  int unstable = 0;         ///< strands that are held in an equilibrium that is not stable
  int without_rest = 0;     ///< elements that hold more than their shape can: at rest nowhere
};

/// A pin, and where it starts.
struct PlacedPin : Pin {
  Eigen::Vector3d start;  ///< position at time 0, m
};

/// What is simulated: strands, the terms of their potential, and the stages that a step runs
/// through. Not movable, since its parts refer to each other.
struct Model {
  /// is_held: of each strand, whether it is not solved for since all of it is pinned.
  explicit Model(Strands given, const std::vector<bool>& is_held = {});
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  const Strands strands;
  const StrandGroups groups;
  Motions motions;
  std::vector<std::unique_ptr<Energy>> energies;
  std::vector<std::unique_ptr<CouplingEnergy>> couplings;
  std::vector<std::unique_ptr<Force>> forces;
  std::unique_ptr<CollisionStage> collision;  ///< null: the scene has no collision
  std::unique_ptr<LinearSolver> solver;
  std::vector<LeftOut> left_out;   ///< terms that vanish
  std::optional<RestReport> rest;  ///< of a scene that chooses a rest state
  /// Pins vertices, and marks what is free; positions: of all vertices at time 0, m.
  void set_pins(std::span<const Pin> given, std::span<const Eigen::Vector3d> positions);
  std::vector<PlacedPin> pins;
  VertexScalars free;          ///< 1: free; 0: pinned, or a pad
  std::vector<char> has_pins;  ///< whether a row holds a pinned vertex
  VertexScalars mass;          ///< kg; 1 on pads

  /// Whether anything may couple strands.
  bool may_couple() const { return collision != nullptr || !couplings.empty(); }
};

/// The names of the elastic terms, as StepReport::energies has them: energies, then couplings.
std::vector<std::string> energy_names(const Model& model);

/// The names of the elastic terms that are left out, since they are always zero.
std::vector<std::string> left_out_energy_names(const Model& model);

/// Tells energies, couplings and forces, in this order, that a step of length dt, s, begins.
void begin_step(Model& model, const State& state, double dt, const EndVelocity& velocity);

}  // namespace ringlet
