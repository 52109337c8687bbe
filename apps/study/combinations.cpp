#include "apps/study/combinations.h"

namespace ringlet {
namespace {

std::vector<Combination> grid(const std::vector<StudyAxis>& axes) {
  std::vector<Combination> all{{}};
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    std::vector<Combination> longer;
    for (const Combination& combination : all) {
      for (std::size_t value = 0; value < axes[axis].values.size(); ++value) {
        longer.push_back(combination);
        longer.back().push_back({axis, value});
      }
    }
    all = std::move(longer);
  }
  return all;
}

std::vector<Combination> zip(const std::vector<StudyAxis>& axes) {
  std::vector<Combination> all(axes.front().values.size());
  for (std::size_t value = 0; value < all.size(); ++value) {
    for (std::size_t axis = 0; axis < axes.size(); ++axis) all[value].push_back({axis, value});
  }
  return all;
}

std::vector<Combination> one_at_a_time(const std::vector<StudyAxis>& axes) {
  std::vector<Combination> all;
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    for (std::size_t value = 0; value < axes[axis].values.size(); ++value) {
      all.push_back({{axis, value}});
    }
  }
  return all;
}

}  // namespace

std::vector<Combination> combine(const StudyFile& study) {
  if (study.axes.empty()) return {};
  switch (study.combine) {
    case Combine::grid:
      return grid(study.axes);
    case Combine::zip:
      return zip(study.axes);
    case Combine::one_at_a_time:
      return one_at_a_time(study.axes);
  }
  return {};
}

}  // namespace ringlet
