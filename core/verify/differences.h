#pragma once

#include <functional>

#include "core/verify/probe.h"

namespace ringlet {

/// The derivative of a vector function along one coordinate of x by central differences, of
/// shrinking steps extrapolated to zero (Ridders 1982); the extrapolation that moves least is
/// taken.
Eigen::VectorXd difference_along(const std::function<Eigen::VectorXd(const Points&)>& function,
                                 const Points& x, int coordinate, double first_step);

/// The derivatives along all coordinates, a column a coordinate.
Eigen::MatrixXd differences(const std::function<Eigen::VectorXd(const Points&)>& function,
                            const Points& x, double first_step);

}  // namespace ringlet
