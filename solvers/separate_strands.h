#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <vector>

#include "solvers/newton_iterations.h"
#include "solvers/newton_step.h"

namespace ringlet {

/// Newton's method for each group of strands by itself, where nothing couples strands and a factor
/// of their bands solves for them: a group goes through all its iterations while what belongs to it
/// is in cache, needs no more of them than its own strands do, and never waits for another's line
/// search.
class SeparateStrands {
 public:
  /// Whether a model can be solved like this.
  static bool suit(const Model& model) {
    return !model.may_couple() && model.solver->band_factor() != nullptr;
  }

  /// Allocates for a model.
  void bind(const Model& model);

  /// Moves x, the first guess, towards the minimum. The outcome has the most iterations and
  /// halvings of a group, and the largest update; if some fail, it is that of the first of them.
  NewtonOutcome minimise(const NewtonParameters& parameters, const NewtonStep& step,
                         VertexField& x);
  /// Of the potential at x, where minimise() moved it.
  const PotentialTerms& terms() const { return terms_; }
  std::size_t bytes() const;

 private:
  class Problem;
  struct Trials {
    std::vector<Vector3<Pack>> here, next;
  };
  struct Solved {
    NewtonOutcome outcome;
    double seconds = 0, line_search_seconds = 0;
  };
  Solved minimise_group(const NewtonParameters& parameters, const NewtonStep& step, int group,
                        VertexField& x);
  NewtonOutcome outcome_of_all() const;

  tbb::enumerable_thread_specific<Trials> trials_;
  std::vector<Solved> solved_;  ///< each group
  PotentialTerms terms_;
};

}  // namespace ringlet
