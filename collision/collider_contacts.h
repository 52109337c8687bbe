#pragma once

#include <memory>
#include <span>
#include <vector>

#include "collision/contact_law.h"
#include "collision/continuous.h"
#include "collision/edge_chunks.h"
#include "collision/movement.h"
#include "collision/touching.h"
#include "core/collider.h"
#include "core/collision_stage.h"

namespace ringlet {

/// Vertices against colliders, which motions place.
class ColliderContacts {
 public:
  ColliderContacts(std::vector<std::unique_ptr<Collider>> colliders, ContactLaw law, double margin)
      : colliders_(std::move(colliders)), law_(law), margin_(margin) {}

  /// The arguments outlive this. Colliders stand where they are at time 0.
  void bind(const std::vector<EdgeChunk>& chunks, const Motions& motions);
  std::vector<Pin> pins(std::span<const Eigen::Vector3d> positions) const;
  void set_free(std::vector<bool> is_free) { is_free_ = std::move(is_free); }
  /// Places the colliders where they are at the end of a step.
  void move_to(double time_end, double dt);

  /// Collects the free vertices nearer to a collider than the thickness and the margin.
  void detect(std::span<const Eigen::Vector3d> positions);
  /// The same with a margin, m, for a way that is no longer; they are valid for that alone.
  void detect_on_way(std::span<const Eigen::Vector3d> positions, double margin);
  /// The part of straight ways that candidates may go before less is left of the distance of one to
  /// its collider than must be; 1: all of it, 0: one is inside at the start.
  double free_part(std::span<const Eigen::Vector3d> from, std::span<const Eigen::Vector3d> to,
                   const KeptGap& kept) const;
  /// The same of all free vertices, for ways from the start of the step, seen from the moving
  /// colliders.
  double free_part_of_step(std::span<const Eigen::Vector3d> start,
                           std::span<const Eigen::Vector3d> to, const KeptGap& kept) const;
  /// Moves every free vertex that a moving collider hits on its way in the step along with it.
  void carry_what_is_hit(std::span<const Eigen::Vector3d> start,
                         std::span<Eigen::Vector3d> to) const;
  /// Whether no vertex but the candidates can be nearer to a collider than the thickness.
  bool are_valid(std::span<const Eigen::Vector3d> positions) const;
  int candidate_count() const { return static_cast<int>(vertices_.size()); }
  /// How deep, m, a free vertex is inside of a collider at most; 0 if none is.
  double deepest(std::span<const Eigen::Vector3d> positions) const;
  /// How far, m, the collider of a candidate has moved a point of it since the step began.
  Eigen::Vector3d displacement(int candidate, const Eigen::Vector3d& point) const;
  /// Which candidates touch at x.
  void evaluate(const VertexField& x, Touching& touching) const;

  std::size_t bytes() const;

 private:
  /// Candidates that a collider is asked about together.
  struct Batch {
    int collider;
    int begin, end;  // in vertices_
  };
  void evaluate_batch(const Batch& batch, const VertexField& x,
                      std::vector<Touching::Found>& found) const;
  double free_part(int collider, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                   const KeptGap& kept) const;
  std::vector<int> find_reachable(int collider, std::span<const Eigen::Vector3d> start,
                                  std::span<const Eigen::Vector3d> to) const;
  void collect(std::span<const Eigen::Vector3d> positions, double margin);
  /// Of a chunk's own vertices, those nearer to a collider than reach: replaces `vertices`.
  void find_near(int collider, const EdgeChunk& chunk, bool free_only,
                 std::span<const Eigen::Vector3d> positions, double reach,
                 std::vector<int>& vertices) const;

  std::vector<std::unique_ptr<Collider>> colliders_;
  ContactLaw law_;
  double margin_;
  const std::vector<EdgeChunk>* chunks_ = nullptr;
  const Motions* motions_ = nullptr;
  std::vector<bool> is_free_;
  std::vector<Eigen::Isometry3d> placements_;   // of each collider's frame
  std::vector<Eigen::Isometry3d> since_begin_;  // the motion of each in this step
  std::vector<Eigen::Isometry3d> detected_;     // the placements when candidates were collected
  Movement movement_;                           // since then
  std::vector<std::vector<int>> near_;          // vertices of each chunk
  std::vector<int> vertices_;
  std::vector<int> collider_of_;  // of each candidate
  std::vector<Batch> batches_;
};

}  // namespace ringlet
