#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "collision/audit.h"
#include "collision/collider_contacts.h"
#include "collision/friction.h"
#include "collision/movement.h"
#include "collision/strand_contacts.h"
#include "collision/touching.h"
#include "core/collision_stage.h"
#include "core/registry.h"

namespace ringlet {

/// When candidate pairs are collected anew.
enum class DetectWhen { iteration, step, margin };

template <>
struct EnumNames<DetectWhen> {
  static constexpr std::pair<DetectWhen, const char*> names[] = {
      {DetectWhen::iteration, "iteration"},
      {DetectWhen::step, "step"},
      {DetectWhen::margin, "margin"}};
};

struct FclStageParameters {
  double thickness = 1e-3;
  double stiffness = 2;
  bool strand_contacts = true;
  bool push_at_rest = false;
  double rest_slack = 0.1;
  std::optional<double> arc_distance;
  std::optional<double> collider_thickness;
  std::optional<double> collider_stiffness;
  double friction = 0;
  std::optional<double> collider_friction;
  double sticking_speed = 1e-3;
  bool audit = false;
  std::optional<double> margin;
  Choice<ContactDetector> detector = "fcl";
  Choice<ContactEnergy> response = "penalty";
  DetectWhen detect = DetectWhen::margin;
  std::vector<Choice<Collider>> colliders;

  static Schema<FclStageParameters> schema();
};

/// Contacts between strands, found with FCL, and between strands and colliders, resisted by a
/// contact energy.
class FclStage final : public CollisionStage {
 public:
  explicit FclStage(const FclStageParameters& parameters);

  void bind(const Strands& strands, const StrandGroups& groups, const Motions& motions) override;
  std::vector<Pin> pins(const std::vector<Eigen::Vector3d>& positions) const override;
  void set_free(const VertexScalars& free) override;
  void begin_step(const VertexField& x_n, double time_end, double dt) override;
  bool can_reach(const VertexField& x_n, VertexField& guess) override;
  double step_limit(const VertexField& x, const VertexField& d) override;
  void detect(const VertexField& x) override;
  double add(const VertexField& x, Couplings* couplings) override;
  void end_step(const VertexField& x) override;
  ContactReport report() const override { return report_; }
  std::size_t bytes() const override;

 private:
  void bind_strand_contacts(const Strands& strands);
  /// Whether all that comes nearer than the thickness on a straight way is a candidate.
  bool are_candidates_valid(std::span<const Eigen::Vector3d> from,
                            std::span<const Eigen::Vector3d> to) const;
  void find_candidates(const VertexField& x);
  void find_candidates_of_way(std::span<const Eigen::Vector3d> to);
  void collect_candidates();
  void collect_missing_candidates(std::span<const Eigen::Vector3d> to);
  void gather(const VertexField& x);
  void follow(const VertexField& x);
  void evaluate(const VertexField& x);
  bool is_evaluated_at(const VertexField& x) const;
  void lag_friction(const VertexField& x);

  FclStageParameters parameters_;
  std::unique_ptr<ContactEnergy> response_;
  std::optional<StrandContacts> strand_contacts_;  // absent: strands do not feel each other
  ColliderContacts collider_contacts_;
  const StrandGroups* groups_ = nullptr;
  std::vector<EdgeChunk> chunks_;
  bool is_new_step_ = true;
  bool is_swept_ = false;                           // candidates are those of the way that led here
  StreamedVector<Eigen::Vector3d> positions_;       // of the last detect()
  Touching touching_strands_, touching_colliders_;  // at the positions of the last evaluate()
  VertexField evaluated_;                           // these positions
  bool is_evaluated_ = false;                       // of the candidates as they are now
  Friction friction_;
  std::optional<Audit> audit_;
  ContactReport report_;
};

}  // namespace ringlet
