#pragma once

#include "core/registry.h"

namespace ringlet {

// The baseline to which the ratios of `ringlet bench` refer: the same time step in the plain way.
//
//   - elements one after the other in plain doubles, not in lanes;
//   - the eigenvalues of each element's Hessian computed and clamped numerically;
//   - triplets into an Eigen::SparseMatrix over all unknowns, contacts included;
//   - Eigen's ConjugateGradient with its diagonal preconditioner, or Eigen's SimplicialLDLT.
//
// Newton's method, the line search and the detection of contacts are those of the fast step. In
// favour of the baseline, blocks of one strand are summed before they become triplets.

enum class BaselineSolver { conjugate_gradient, ldlt };

/// The plugins that are given, and those of the baseline.
Registry with_baseline(Registry registry);

/// The scene, computed in the plain way; to be read with with_baseline(). The tolerance of its
/// linear solver, if it has one, stays; but Eigen takes it for |b - A x| / |b|.
Json baseline_scene(Json scene, BaselineSolver solver);

}  // namespace ringlet
