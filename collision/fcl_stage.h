#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "collision/audit.h"
#include "collision/collider_contacts.h"
#include "collision/contact_rule.h"
#include "collision/continuous_detection.h"
#include "collision/friction.h"
#include "collision/movement.h"
#include "collision/rest_pairs.h"
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

 private:
  void bind_strand_contacts(const Strands& strands);
  bool are_candidates_valid() const;
  bool is_covered(std::span<const Eigen::Vector3d> from, std::span<const Eigen::Vector3d> to,
                  double reach) const;
  void collect_candidates();
  void find_candidates_of_way(std::span<const Eigen::Vector3d> to);
  void sweep(std::span<const Eigen::Vector3d> from, std::span<const Eigen::Vector3d> to,
             double reach);
  void find_candidates(const VertexField& x);
  void gather(const VertexField& x);
  void follow(const VertexField& x);
  void limit_thickness();
  double stiffness_of(int pair) const;
  void evaluate(const VertexField& x);
  /// Of count candidate pairs from the first on, no more than there are lanes.
  void add_touching(int first, int count, const VertexField& x,
                    std::vector<Touching::Found>& found) const;
  void lag_friction(const VertexField& x);

  FclStageParameters parameters_;
  std::unique_ptr<ContactEnergy> response_;
  ColliderContacts collider_contacts_;
  const StrandGroups* groups_ = nullptr;
  std::vector<EdgeChunk> chunks_;
  std::optional<ContactRule> rule_;
  std::unique_ptr<ContactDetector> detector_;  // null: strands do not feel each other
  bool is_new_step_ = true;
  bool is_swept_ = false;                         // candidates are those of the way that led here
  Movement movement_;                             // since candidates were collected
  std::vector<Eigen::Vector3d> positions_;        // of the last detect()
  std::optional<RestPairs> rest_pairs_;           // absent: pairs push at rest too
  std::vector<EdgePair> pairs_;                   // candidates
  std::vector<double> thickness_;                 // of each pair
  Touching strand_contacts_, touched_colliders_;  // at the positions of the last evaluate()
  Friction friction_;
  std::optional<ContinuousDetection> continuous_;  // of strands, for an audit or a barrier
  std::optional<Audit> audit_;
  ContactReport report_;
};

}  // namespace ringlet
