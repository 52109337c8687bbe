#pragma once

#include <Eigen/SparseCore>

#include "core/system_matrix.h"

namespace ringlet {

/// The matrix over the unknowns of all vertices (three each, without the pads), of triplets; both
/// triangles. The bands must have been kept.
Eigen::SparseMatrix<double> sparse_matrix(const SystemMatrix& a);

}  // namespace ringlet
