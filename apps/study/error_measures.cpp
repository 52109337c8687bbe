#include "apps/study/error_measures.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "apps/study/curl_shape.h"
#include "apps/study/resample.h"

namespace ringlet {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// The mean over the strands that have a value; not a number if none has.
double mean_over_strands(
    const Eigen::Matrix3Xd& positions, const std::vector<int>& counts,
    const std::function<std::optional<double>(const Eigen::Ref<const Eigen::Matrix3Xd>&)>&
        measure) {
  double sum = 0;
  int measured = 0, first = 0;
  for (const int count : counts) {
    if (const auto value = measure(positions.middleCols(first, count))) {
      sum += *value;
      ++measured;
    }
    first += count;
  }
  return measured > 0 ? sum / measured : none;
}

double relative(double value, double reference) {
  return std::abs(value - reference) / std::abs(reference);
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

/// The largest that is a number.
double larger(double a, double b) { return std::isnan(a) || b > a ? b : a; }

struct AtTime {
  double mean_distance, max_distance, curl_radius, length, energy;
};

}  // namespace

const std::vector<ErrorMeasure>& error_measures() {
  static const std::vector<ErrorMeasure> all{
      {"mean_distance", "mean distance of vertices", "m"},
      {"max_distance", "largest distance of a vertex", "m"},
      {"curl_radius", "error of the curl radius", ""},
      {"length", "error of the length from root to tip", ""},
      {"energy", "error of the energy", ""},
      {"penetration", "deepest penetration of contacts", "m"}};
  return all;
}

std::vector<std::string> error_names() {
  std::vector<std::string> names;
  for (const ErrorMeasure& measure : error_measures()) names.push_back(measure.name);
  return names;
}

MeasuredErrors measure_errors(const std::vector<ComparedState>& states,
                              const std::vector<int>& counts,
                              const std::vector<ComparedState>& reference,
                              const std::vector<int>& reference_counts) {
  const Resampling resampled(reference_counts, counts);
  double largest_energy = 0;
  for (const ComparedState& state : reference) {
    largest_energy = std::max(largest_energy, std::abs(state.energy));
  }
  MeasuredErrors measured;
  AtTime all{0, 0, none, none, none};
  const std::size_t times = std::min(states.size(), reference.size());
  for (std::size_t i = 0; i < times; ++i) {
    const ComparedState &state = states[i], &right = reference[i];
    const Eigen::VectorXd distances =
        (state.positions - resampled(right.positions)).colwise().norm();
    const AtTime at{distances.mean(), distances.maxCoeff(),
                    relative(mean_over_strands(state.positions, counts, curl_radius),
                             mean_over_strands(right.positions, reference_counts, curl_radius)),
                    relative(mean_over_strands(state.positions, counts, end_distance),
                             mean_over_strands(right.positions, reference_counts, end_distance)),
                    std::abs(state.energy - right.energy) / largest_energy};
    all.mean_distance += at.mean_distance / static_cast<double>(times);
    all.max_distance = std::max(all.max_distance, at.max_distance);
    all.curl_radius = larger(all.curl_radius, at.curl_radius);
    all.length = larger(all.length, at.length);
    all.energy = larger(all.energy, at.energy);
    measured.at.push_back({{"time", state.time},
                           {"mean_distance", number(at.mean_distance)},
                           {"max_distance", number(at.max_distance)},
                           {"curl_radius", number(at.curl_radius)},
                           {"length", number(at.length)},
                           {"energy", number(at.energy)}});
  }
  measured.largest_distance = all.max_distance;
  if (times == 0) return measured;
  measured.errors = {{"mean_distance", number(all.mean_distance)},
                     {"max_distance", number(all.max_distance)},
                     {"curl_radius", number(all.curl_radius)},
                     {"length", number(all.length)},
                     {"energy", number(all.energy)}};
  return measured;
}

}  // namespace ringlet
