#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/parameters.h"

namespace ringlet {

/// A variant with a place in the picture.
struct PicturePoint {
  std::string name;
  double seconds, seconds_low, seconds_high;
  double value;        ///< of what the picture shows against time; zero has no logarithm
  int colour, symbol;  ///< which value of the first and the second axis; -1 if it has none
  bool converged;
};

/// What variants differ in.
struct PictureAxis {
  std::string name, title;  ///< the title with its unit
  std::vector<std::string> values;
};

/// What the picture of a study shows.
struct PictureData {
  std::string study, about, timing_note;
  std::vector<PictureAxis> axes;
  std::string label, unit;  ///< of what it shows against time: the first error
  std::vector<PicturePoint> points;
  std::vector<std::size_t> front;              ///< among the points, fastest first
  std::optional<std::size_t> default_variant;  ///< among the points
  std::vector<std::string> without_place;      ///< name, status and reason of every other variant
};

/// Without errors, since there is no reference, Newton iterations take their place. What exploded,
/// failed, was refused or interrupted, or has no time or value, has no place among the points.
PictureData picture_data(const Json& results);

}  // namespace ringlet
