#include "apps/study/curl_shape.h"

#include <cmath>

namespace ringlet {
namespace {

/// What is straighter than this part of its edges is straight, but for rounding.
constexpr double straight = 1e-9;

}  // namespace

std::optional<double> curl_radius(const Eigen::Ref<const Eigen::Matrix3Xd>& strand) {
  const Eigen::Index n = strand.cols();
  if (n < 4) return std::nullopt;
  const Eigen::Matrix3Xd edges = strand.rightCols(n - 1) - strand.leftCols(n - 1);
  const Eigen::Matrix3Xd d = edges.rightCols(n - 2) - edges.leftCols(n - 2);
  const Eigen::VectorXd lengths = d.colwise().norm();
  const double products = lengths.head(n - 3).dot(lengths.tail(n - 3));
  if (!(lengths.maxCoeff() > straight * edges.colwise().norm().maxCoeff())) return std::nullopt;
  const double cos_theta = d.leftCols(n - 3).cwiseProduct(d.rightCols(n - 3)).sum() / products;
  if (!(cos_theta < 1)) return std::nullopt;
  const double mean_square = lengths.squaredNorm() / static_cast<double>(lengths.size());
  return std::sqrt(mean_square) / (2 * (1 - cos_theta));
}

double end_distance(const Eigen::Ref<const Eigen::Matrix3Xd>& strand) {
  return (strand.rightCols<1>() - strand.leftCols<1>()).norm();
}

}  // namespace ringlet
