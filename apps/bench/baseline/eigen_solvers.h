#pragma once

#include "core/registry.h"

namespace ringlet {

/// "eigen_cg": Eigen::ConjugateGradient, diagonal preconditioner.
void register_eigen_cg(Registry& registry);
/// "eigen_ldlt": Eigen::SimplicialLDLT, ordered by approximate minimum degree.
void register_eigen_ldlt(Registry& registry);

}  // namespace ringlet
