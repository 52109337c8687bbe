#include "apps/bench/element_timing.h"

#include <numbers>

#include "core/verify/subject.h"

namespace ringlet {
namespace {

/// Curls of the paper's shape, one after the other.
Points curls(int count, int vertices) {
  Points x(3, count * vertices);
  for (int v = 0; v < x.cols(); ++v) {
    const double turn = 2 * std::numbers::pi / 5 * (v % vertices);
    x.col(v) = 0.005 * Eigen::Vector3d(std::cos(turn), 0.2 * (v % vertices), std::sin(turn));
  }
  return x;
}

}  // namespace

Timing time_element(const EnergyMaker& make, const Json& keys, const BenchOptions& options) {
  const int count = options.quick() ? 8 : 128;
  constexpr int vertices = 101;
  std::mt19937_64 random(1);
  const Points rest = curls(count, vertices);
  const Points x = rest + 0.001 * random_points(random, count * vertices);
  const BoundEnergy bound(make(keys), std::vector<int>(count, vertices), rest);
  const VertexField field = positions_with_pads(bound.groups(), columns(x));
  EdgeDerivatives derivatives;
  derivatives.begin(vertices);
  const EdgeOutputs outputs = derivatives.outputs();
  const Timing timing = measure(
      [&] {
        for (int g = 0; g < bound.groups().count(); ++g) {
          bound.energy().add(g, field.group(g), outputs);
        }
      },
      options.seconds);
  const double elements = count * (vertices - smallest_strand(make, random) + 1);
  return {timing.median / elements, timing.spread / elements};
}

}  // namespace ringlet
