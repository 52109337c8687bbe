#pragma once

#include <limits>
#include <string>
#include <vector>

#include "core/couplings.h"
#include "core/motion.h"
#include "core/named.h"
#include "core/strands.h"
#include "core/vertex_field.h"

namespace ringlet {

/// A vertex that follows a prescribed motion.
struct Pin {
  int vertex;
  std::string motion;  ///< name; empty: it stays where it starts
};

/// What a collision stage says about its last evaluation.
struct ContactReport {
  int strand_contacts = 0;    ///< pairs of strand edges closer than the thickness
  int collider_contacts = 0;  ///< vertices closer to a collider than the thickness
  double penetration = 0;     ///< deepest violation of the thickness, m
  /// Of the whole step, by an audit; not a number without one: pairs of edges that passed through
  /// each other, and how deep, m, a free vertex is inside of a collider at the end.
  double crossings = std::numeric_limits<double>::quiet_NaN();
  double depth = std::numeric_limits<double>::quiet_NaN();
};

/// Finds contacts and resists them. A scene that names no collision has no stage at all.
class CollisionStage : public Named {
 public:
  virtual ~CollisionStage() = default;

  /// Called once. The arguments outlive the stage.
  virtual void bind(const Strands& strands, const StrandGroups& groups, const Motions& motions) = 0;
  /// Vertices that start inside a collider that pins them.
  virtual std::vector<Pin> pins(const std::vector<Eigen::Vector3d>& positions) const = 0;
  /// Pinned vertices do not feel contacts: free is 1 for a free vertex. Called before detect().
  virtual void set_free(const VertexScalars& free) = 0;
  /// A step begins: colliders move to their place at the end of the step. x_n are its first
  /// positions.
  virtual void begin_step(const VertexField& x_n, double time_end, double dt) = 0;
  /// Whether the first guess of the step can be reached from its first positions: whether nothing
  /// that must not passes through each other as pins and colliders move. Free vertices that a
  /// collider would hit are moved along with it.
  virtual bool can_reach(const VertexField& x_n, VertexField& guess) = 0;
  /// The largest alpha, at most 1, so that nothing that must not passes through each other on the
  /// way from x to x - alpha d. Until the next detect(), contacts are complete all along this way.
  virtual double step_limit(const VertexField& x, const VertexField& d) = 0;
  /// Collects candidate pairs near positions x. Called before every Newton iteration.
  virtual void detect(const VertexField& x) = 0;
  /// Returns the contact energy of the candidates at x, J; adds its terms unless null. Results do
  /// not depend on the number of threads.
  virtual double add(const VertexField& x, Couplings* couplings) = 0;
  /// The step ends at x.
  virtual void end_step(const VertexField& x) = 0;
  /// About the last add(), or, after end_step(), the step.
  virtual ContactReport report() const = 0;
};

}  // namespace ringlet
