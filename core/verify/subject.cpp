#include "core/verify/subject.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>

#include "core/batch_energy.h"

namespace ringlet {

namespace {

std::vector<std::string> offered_filters(const EnergyMaker& make) {
  std::vector<std::string> names;
  for (const auto& [filter, name] : EnumNames<Filter>::names) {
    if (make({{"filter", name}}) != nullptr) names.push_back(name);
  }
  return names;
}

void add_states(std::mt19937_64& random, int vertices, double nearly, int trials,
                std::vector<VerifyState>& states) {
  for (const Shape shape : all_shapes) {
    for (int trial = 0; trial < trials; ++trial) {
      const double size = trial % 2 == 0 ? 1 : 1e-3;
      const int more = trial % 3 == 2 ? 3 : 0;
      const Points rest = random_strand(random, vertices + more, Shape::generic);
      const Points x = random_strand(random, vertices + more, shape, nearly);
      states.push_back(
          {fmt::format("{}, {:.0e}, edges {} m, trial {}", shape_name(shape), nearly, size, trial),
           size * rest, size * x});
    }
  }
}

}  // namespace

int smallest_strand(const EnergyMaker& make, std::mt19937_64& random) {
  constexpr int most = 8;
  for (int vertices = 2; vertices <= most; ++vertices) {
    const Points rest = random_strand(random, vertices, Shape::generic);
    const BoundEnergy energy(make(Json::object()), rest);
    const double value = energy.value(random_strand(random, vertices, Shape::generic));
    if (value != 0) return vertices;
  }
  throw Error(fmt::format("the energy of random strands of 2 to {} vertices is 0", most));
}

void Claim::see(double error, const std::string& state) {
  ++states;
  if (states > 1 && !(error > worst || std::isnan(error))) return;
  if (std::isnan(worst)) return;
  worst = error;
  worst_state = state;
}

Subject::Subject(const EnergyMaker& maker, const VerifyOptions& options)
    : make(maker), seed(options.seed) {
  std::mt19937_64 random(seed);
  vertices = smallest_strand(make, random);
  filters = offered_filters(make);
  add_states(random, vertices, 0.02, options.trials, states);
  add_states(random, vertices, 1e-6, options.trials, near_states);
  add_states(random, vertices, 1e-12, options.trials, near_states);
}

bool Subject::has_filter(const std::string& name) const {
  return std::find(filters.begin(), filters.end(), name) != filters.end();
}

std::vector<std::string> Subject::variants() const {
  return filters.empty() ? std::vector<std::string>{""} : filters;
}

std::unique_ptr<Energy> Subject::energy(const std::string& filter, Json keys) const {
  if (!filter.empty()) keys["filter"] = filter;
  return make(keys);
}

BoundEnergy Subject::bound(const std::string& filter, const VerifyState& state) const {
  return BoundEnergy(energy(filter), state.rest);
}

double largest_entry(const Eigen::MatrixXd& matrix) { return matrix.cwiseAbs().maxCoeff(); }

double negative_part(const Eigen::MatrixXd& matrix, double scale) {
  return scale == 0 ? 0 : std::max(0.0, -smallest_eigenvalue(matrix / scale));
}

double relative_difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double least) {
  const double difference = (a - b).cwiseAbs().maxCoeff();
  return difference == 0 ? 0 : difference / std::max(b.cwiseAbs().maxCoeff(), least);
}

}  // namespace ringlet
