// The capstan: around a fixed cylinder a rope that slides has tensions in the ratio exp(mu phi).

#include <numbers>

#include "tests/catch.h"
#include "tests/collision/physics/simulate.h"

using namespace ringlet;

namespace {

constexpr double mu = 0.2, radius = 0.02, hanging = 1;
constexpr int arc_edges = 60, tail_edges = 60, pulled_edges = 4;

/// A rope from the pulled end, half around the cylinder, to the end that hangs.
Json rope() {
  const double at = radius + 4e-4, edge = std::numbers::pi * at / arc_edges;
  Json vertices = Json::array();
  for (int i = -pulled_edges; i <= arc_edges; ++i) {
    const double angle = i * edge / at;
    if (i < 0)
      vertices.push_back({at, i * edge, 0});
    else
      vertices.push_back({at * std::cos(angle), at * std::sin(angle), 0});
  }
  for (int i = 1; i <= tail_edges; ++i) vertices.push_back({-at, -hanging * i / tail_edges, 0});
  return vertices;
}

Simulation capstan() {
  return simulate(R"({"motions": {"pull": [{"type": "keyframes", "times": [0, 1],
      "translations": [[0, 0, 0], [0, -0.05, 0]]}]},
    "strands": {"type": "explicit", "pinned": 1, "motion": "pull", "strands": [)" +
                  rope().dump() + R"(]},
    "material": {"youngs_modulus": 1e9, "radius": 1e-4},
    "energies": ["stretch"], "forces": [{"type": "gravity", "acceleration": [0, -9.81, 0]}],
    "collision": {"type": "fcl", "strand_contacts": false, "collider_stiffness": 20,
      "collider_friction": )" +
                  std::to_string(mu) + R"(,
      "colliders": [{"type": "capsule", "from": [0, 0, -1], "to": [0, 0, 1], "radius": 0.02}]},
    "solver": "strand_cholesky",
    "integrator": {"type": "bdf1", "dt": 0.002, "newton_iterations": 50, "newton_tolerance": 1e-5}})");
}

/// The tension of an edge from its strain, N.
double tension(const Simulation& simulation, int edge) {
  const Strands& strands = simulation.model().strands;
  const VertexField& x = simulation.state().positions;
  const double strain = (x.get(edge + 1) - x.get(edge)).norm() / strands.rest_length(edge) - 1;
  return strands.material().youngs_modulus.at(strands, 0) * std::numbers::pi * 1e-8 * strain;
}

}  // namespace

TEST_CASE("tensions of a rope that slides over half a turn of a cylinder") {
  Simulation simulation = capstan();
  double ratio = 0;
  const int settling = 150, measured = 150;
  for (int step = 0; step < settling + measured; ++step) {
    REQUIRE(simulation.step().failure.empty());
    if (step < settling) continue;
    // The edges beside the top of which no vertex touches the cylinder.
    int pulled = 0, hung = 0;
    const VertexField& x = simulation.state().positions;
    for (int v = 0; v < arc_edges + tail_edges; ++v) {
      const Eigen::Vector3d a = x.get(v), b = x.get(v + 1);
      if (a.x() > 0 && b.y() < 0) pulled = v;
      if (a.x() < 0 && a.y() < 0 && hung == 0) hung = v;
    }
    ratio += tension(simulation, pulled) / tension(simulation, hung) / measured;
  }
  CHECK(ratio == Approx(std::exp(mu * std::numbers::pi)).epsilon(0.03));
}
