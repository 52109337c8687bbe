#pragma once

#include <Eigen/Core>
#include <vector>

namespace ringlet {

/// Points of the unit sphere with y >= lowest, evenly spread but without pattern: no two are
/// nearer than about 0.6 of the spacing of a hexagonal lattice (below). 1 <= count <= 1e8, -1 <=
/// lowest < 1. The time grows as count log(count); 20,000 points take a fraction of a second.
///
/// Sample elimination: of five times as many uniform samples, the most crowded one is taken away
/// until count are left. Source: C. Yuksel, Sample Elimination for Generating Poisson Disk Sample
/// Sets, Computer Graphics Forum 34(2), 2015, with alpha = 8 and no weight limiting.
std::vector<Eigen::Vector3d> blue_noise_on_sphere(int count, double lowest, unsigned seed);

/// The distance between neighbours of a hexagonal lattice of so many points on so large an area:
/// sqrt(2 area / (sqrt(3) count)).
double hexagonal_spacing(double area, int count);

}  // namespace ringlet
