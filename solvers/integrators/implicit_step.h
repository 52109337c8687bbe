#pragma once

#include <optional>

#include "core/incremental_potential.h"
#include "core/parallel.h"
#include "core/state.h"
#include "solvers/integrators/implicit_parameters.h"

namespace ringlet {

/// How an implicit method goes from one state to the next: the positions x at the end of a step
/// minimise
///
///     (x - y)^T M (x - y) / (2 h^2) + potentials
///
/// and the velocities there are (x - o) / interval (math.md, section 6).
struct StepRule {
  double h;                   ///< effective time step of the inertia, s; infinite: no inertia
  double interval;            ///< s
  const VertexField& origin;  ///< o, m
};

/// One step of any such method: first guess, collisions, Newton's method, the new state.
class ImplicitStep {
 public:
  explicit ImplicitStep(const ImplicitParameters& parameters)
      : newton_(parameters.newton), sleepers_(parameters.sleep) {}

  /// Allocates for a model. Called once.
  void bind(const Model& model);

  /// y, the inertial target, m: to be written before solve().
  VertexField target;
  /// Solves for the positions at state.time + dt. If the report names a failure, they are of no
  /// use.
  StepReport solve(Model& model, const State& state, double dt, const StepRule& rule);
  const VertexField& positions() const { return positions_; }
  std::size_t bytes() const;
  /// Moves the solved positions into the state, and finds velocities, time and kinetic energy.
  void finish(const Model& model, State& state, double dt, const StepRule& rule,
              StepReport& report);

 private:
  bool find_reachable_guess(const Model& model, const State& state, double time_end);

  Newton newton_;
  Sleepers sleepers_;
  VertexField positions_;
  std::optional<IncrementalPotential> potential_;
};

/// body(i) for the index i of each row of the groups, in parallel.
template <class Body>
void for_each_row(const StrandGroups& groups, const Body& body) {
  parallel_for_each(groups.count(), [&](int g) {
    for (int i = groups[g].first_row; i < groups[g].first_row + groups[g].vertices; ++i) body(i);
  });
}

}  // namespace ringlet
