#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/parameters.h"

namespace ringlet {

/// What is measured of a variant against the reference.
struct ErrorMeasure {
  std::string name, label, unit;
};

/// All of them.
const std::vector<ErrorMeasure>& error_measures();
std::vector<std::string> error_names();

/// A run at one of the times at which it is compared.
struct ComparedState {
  double time;                 ///< s
  Eigen::Matrix3Xd positions;  ///< m
  double energy;               ///< elastic and kinetic, J
};

/// Errors of a run by name, null where one has no value, and the same at each time.
struct MeasuredErrors {
  Json errors = Json::object();
  Json at = Json::array();
  double largest_distance = 0;  ///< of a vertex to where the reference has it, m
};

/// Compares states at the same times, as many as there are of both. The counts are the vertices of
/// each strand. Throws Error if strands are not equally many.
///   mean_distance, max_distance: of vertices, over all times; where a strand has other vertices
///   than in the reference, these are compared at equal fractions of the strand
///   curl_radius, length: relative difference of the means over the strands, the largest of all
///   times energy: difference relative to the largest of the reference, the largest of all times
MeasuredErrors measure_errors(const std::vector<ComparedState>& states,
                              const std::vector<int>& counts,
                              const std::vector<ComparedState>& reference,
                              const std::vector<int>& reference_counts);

}  // namespace ringlet
