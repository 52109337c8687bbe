#pragma once

#include <vector>

#include "apps/study/study_file.h"

namespace ringlet {

/// A value of an axis, both by number.
struct AxisValue {
  std::size_t axis, value;

  friend bool operator==(const AxisValue&, const AxisValue&) = default;
};
/// What is changed in one variant.
using Combination = std::vector<AxisValue>;

/// Those that the axes of a study make, in order.
std::vector<Combination> combine(const StudyFile& study);

}  // namespace ringlet
