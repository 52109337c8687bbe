// Glue that holds the strands of a bundle together: a spring between any two vertices of different
// strands that are near each other in the rest shape. A coupling: its terms reach across strands.

#include <cmath>
#include <map>

#include "core/batch_coupling.h"
#include "core/plugin.h"

namespace {

using namespace ringlet;

/// W = k/2 (|x1 - x0| - l)^2, l the distance at rest.
struct BundleGlue {
  struct Parameters {
    double reach = 1e-3;
    Varying stiffness = 1.0;

    static Schema<Parameters> schema() {
      return Schema<Parameters>()
          .key("reach", &Parameters::reach, "m", positive(),
               "vertices of different strands that are nearer at rest are glued")
          .key("stiffness", &Parameters::stiffness, "N/m", at_least(0),
               "of a spring, as its first vertex has it");
    }
  };
  static constexpr int vertices = 2;

  template <class S>
  struct Rest {
    S stiffness;  // N/m
    S length;     // m
  };

  Parameters parameters;

  /// Each pair once, the smaller number first, sorted.
  std::vector<std::array<int, 2>> tuples(const Strands& strands) const {
    using Cell = std::array<long, 3>;
    const auto cell_of = [&](int v) {
      const Eigen::Vector3d x = strands.rest_position(v) / parameters.reach;
      return Cell{std::lround(x.x()), std::lround(x.y()), std::lround(x.z())};
    };
    std::map<Cell, std::vector<int>> cells;
    for (int v = 0; v < strands.vertex_count(); ++v) cells[cell_of(v)].push_back(v);
    std::vector<std::array<int, 2>> pairs;
    for (int v = 0; v < strands.vertex_count(); ++v) {
      const Cell centre = cell_of(v);
      for (int n = 0; n < 27; ++n) {
        const auto cell =
            cells.find({centre[0] + n / 9 - 1, centre[1] + n / 3 % 3 - 1, centre[2] + n % 3 - 1});
        if (cell == cells.end()) continue;
        for (const int other : cell->second) {
          if (other > v && are_glued(strands, v, other)) pairs.push_back({v, other});
        }
      }
    }
    return pairs;
  }

  Rest<double> rest(const TupleRest<2>& tuple) const {
    return {parameters.stiffness.at(tuple.strands, tuple.vertices[0]),
            norm(tuple.positions[1] - tuple.positions[0])};
  }

  template <class S>
  S value(const Stencil<S, 2>& x, const Rest<S>& rest) const {
    const S stretch = norm(x[1] - x[0]) - rest.length;
    return S(0.5) * rest.stiffness * stretch * stretch;
  }

 private:
  bool are_glued(const Strands& strands, int a, int b) const {
    const double distance = (strands.rest_position(a) - strands.rest_position(b)).norm();
    return strands.strand_of(a) != strands.strand_of(b) && distance < parameters.reach;
  }
};

void register_bundle_glue(Registry& registry) {
  register_coupling<BundleGlue>(registry, "bundle_glue",
                                {"springs between strands that lie near each other at rest",
                                 "k/2 (|x1 - x0| - l)^2", "plugins/bundle_glue"});
}

}  // namespace

RINGLET_PLUGIN(register_bundle_glue);
