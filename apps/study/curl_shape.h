#pragma once

#include <Eigen/Core>
#include <optional>

namespace ringlet {

/// The radius, m, of the helix that a strand is, exactly for a discrete helix at any resolution: of
/// its second differences d_i = x_{i+1} - 2 x_i + x_{i-1}, all of length 2 (1 - cos theta) r, two
/// that follow each other make the angle theta, by which the helix turns from vertex to vertex.
/// Lengths and angles are means over the strand. Nothing for a strand of fewer than four vertices,
/// or a straight one.
std::optional<double> curl_radius(const Eigen::Ref<const Eigen::Matrix3Xd>& strand);

/// The distance from root to tip, m.
double end_distance(const Eigen::Ref<const Eigen::Matrix3Xd>& strand);

}  // namespace ringlet
