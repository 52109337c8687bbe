#include "core/verify/differences.h"

#include <limits>
#include <vector>

namespace ringlet {

Eigen::VectorXd difference_along(const std::function<Eigen::VectorXd(const Points&)>& function,
                                 const Points& x, int coordinate, double first_step) {
  constexpr int levels = 10;
  constexpr double shrink = 2;
  Points moved = x;
  double& value = moved.reshaped()(coordinate);
  const double middle = value;
  // Row i of the tableau: the difference with step i, then its extrapolations with those before.
  std::vector<Eigen::VectorXd> previous, row;
  Eigen::VectorXd best;
  double least_movement = std::numeric_limits<double>::infinity();
  double step = first_step;
  for (int i = 0; i < levels; ++i, step /= shrink) {
    const double above = middle + step, below = middle - step;
    value = above;
    Eigen::VectorXd difference = function(moved);
    value = below;
    difference = (difference - function(moved)) / (above - below);
    row = {difference};
    double power = 1;
    for (int j = 0; j < i; ++j) {
      power *= shrink * shrink;
      row.push_back((power * row[j] - previous[j]) / (power - 1));
      const double movement = std::max((row[j + 1] - row[j]).cwiseAbs().maxCoeff(),
                                       (row[j + 1] - previous[j]).cwiseAbs().maxCoeff());
      if (movement <= least_movement) {
        least_movement = movement;
        best = row[j + 1];
      }
    }
    previous = row;
  }
  return best.size() > 0 ? best : row[0];
}

Eigen::MatrixXd differences(const std::function<Eigen::VectorXd(const Points&)>& function,
                            const Points& x, double first_step) {
  Eigen::MatrixXd result;
  for (int i = 0; i < x.size(); ++i) {
    const Eigen::VectorXd column = difference_along(function, x, i, first_step);
    if (i == 0) result.resize(column.size(), x.size());
    result.col(i) = column;
  }
  return result;
}

}  // namespace ringlet
