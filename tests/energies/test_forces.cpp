#include "tests/catch.h"
#include "tests/energies/make.h"

using namespace ringlet;
using namespace ringlet::test;

namespace {

const std::vector<int> counts{4, 6, 3};
constexpr int vertices = 13;
constexpr double dt = 0.05;

/// Strands, a state at the start of a step, and a force.
struct Step {
  Points x_n, x;
  Strands strands;
  StrandGroups groups;
  std::vector<std::unique_ptr<Energy>> energies;
  State state;
  std::unique_ptr<Force> force;

  explicit Step(const Json& json, std::mt19937_64 random = std::mt19937_64(4))
      : x_n(random_points(random, vertices)),
        x(x_n + 0.1 * random_points(random, vertices)),
        strands(counts, columns(random_points(random, vertices)), plain_material()),
        groups(strands),
        state{0, positions_with_pads(groups, columns(x_n)), VertexField(groups)},
        force(make_force(json)) {
    for (const char* name : {"stretch", "bending", "twist"}) {
      energies.push_back(make_energy(name));
      energies.back()->bind(strands, groups);
    }
    force->bind(strands, groups);
    force->begin_step({state, dt, energies, {state.positions, dt}});
  }
  Probe at(const Points& positions) const { return ringlet::probe(*force, groups, positions); }
  double value(const Points& positions) const {
    const VertexField field = positions_with_pads(groups, columns(positions));
    double sum = 0;
    for (int g = 0; g < groups.count(); ++g) sum += force->add(g, field.group(g), {});
    return sum;
  }
};

/// Gradient and Hessian are those of the potential.
void check_derivatives(const Json& json) {
  const Step step(json);
  const Probe probe = step.at(step.x);
  INFO(json.dump());
  REQUIRE(probe.gradient.norm() > 0);
  CHECK(step.value(step.x) == Approx(probe.value).epsilon(1e-13));
  CHECK(probe.asymmetry <= 1e-14 * probe.hessian.norm());
  CHECK(step.force->has_hessian() == (probe.hessian.norm() > 0));
  for (int i = 0; i < probe.gradient.size(); ++i) {
    Points above = step.x, below = step.x;
    above.reshaped()(i) += 1e-4;
    below.reshaped()(i) -= 1e-4;
    const double slope = (step.value(above) - step.value(below)) / 2e-4;
    CHECK(probe.gradient(i) == Approx(slope).margin(1e-7 * probe.gradient.norm()));
    const Eigen::VectorXd row = (step.at(above).gradient - step.at(below).gradient) / 2e-4;
    CHECK((probe.hessian.col(i) - row).norm() <= 1e-7 * (1 + probe.hessian.norm()));
  }
}

}  // namespace

TEST_CASE("forces are the derivatives of their incremental potentials") {
  check_derivatives({{"type", "gravity"}, {"acceleration", {1, -2, 3}}});
  check_derivatives({{"type", "point_force"}, {"force", {1, -2, 3}}});
  check_derivatives({{"type", "point_force"}, {"force", {1, -2, 3}}, {"vertex", 1}});
  check_derivatives({{"type", "drag"}, {"coefficient", 0.3}, {"wind", {1, 2, -1}}});
  check_derivatives({{"type", "rayleigh"}, {"mass", 2}});
  check_derivatives({{"type", "rayleigh"}, {"stiffness", 0.01}});
  check_derivatives({{"type", "rayleigh"}, {"mass", 2}, {"stiffness", 0.01}});
}

TEST_CASE("a point force acts at one vertex of each strand that has it") {
  const auto forces = [](int vertex) {
    const Step step({{"type", "point_force"}, {"force", {1, -2, 3}}, {"vertex", vertex}});
    const Probe probe = step.at(step.x);
    std::vector<int> where;
    for (int v = 0; v < vertices; ++v) {
      const Eigen::Vector3d force = -probe.gradient.segment<3>(3 * v);
      if (force.isZero(0)) continue;
      CHECK(force == Eigen::Vector3d(1, -2, 3));
      where.push_back(v);
    }
    return where;
  };
  CHECK(forces(-1) == std::vector<int>{3, 9, 12});
  CHECK(forces(0) == std::vector<int>{0, 4, 10});
  CHECK(forces(4) == std::vector<int>{8});
}

TEST_CASE("gravity pulls every vertex by its mass") {
  const Step step("gravity");
  const Probe probe = step.at(step.x);
  double value = 0;
  for (int v = 0; v < vertices; ++v) {
    const double weight = 9.81 * step.strands.mass(v);
    CHECK(probe.gradient.segment<3>(3 * v).isApprox(Eigen::Vector3d(0, weight, 0)));
    value += weight * step.x(1, v);
  }
  CHECK(probe.value == Approx(value));
  CHECK(probe.hessian.isZero(0));
}

TEST_CASE("drag is against the velocity relative to the air, per length of strand") {
  const Eigen::Vector3d wind(1, 2, -1);
  const Step step({{"type", "drag"}, {"coefficient", 0.3}, {"wind", {1, 2, -1}}});
  const Probe probe = step.at(step.x);
  for (int v = 0; v < vertices; ++v) {
    const Eigen::Vector3d velocity = (step.x - step.x_n).col(v) / dt;
    const Eigen::Vector3d force = -0.3 * step.strands.voronoi_length(v) * (velocity - wind);
    CHECK(probe.gradient.segment<3>(3 * v).isApprox(-force));
  }
  const Points with_the_wind = step.x_n.colwise() + dt * wind;
  CHECK(step.at(with_the_wind).gradient.norm() < 1e-12);
}

TEST_CASE("Rayleigh damping takes masses and the filtered stiffness at the start of the step") {
  const Step step({{"type", "rayleigh"}, {"mass", 2}, {"stiffness", 0.01}});
  Eigen::MatrixXd damping = Eigen::MatrixXd::Zero(3 * vertices, 3 * vertices);
  for (const auto& energy : step.energies) {
    damping += 0.01 * ringlet::probe(*energy, step.groups, step.x_n).hessian;
  }
  for (int i = 0; i < 3 * vertices; ++i) damping(i, i) += 2 * step.strands.mass(i / 3);
  const Probe probe = step.at(step.x);
  const Eigen::VectorXd velocity = (step.x - step.x_n).reshaped() / dt;
  CHECK(probe.gradient.isApprox(damping * velocity, 1e-12));
  CHECK(probe.hessian.isApprox(damping / dt, 1e-12));
  CHECK(smallest_eigenvalue(probe.hessian) > 0);

  // Stiffness does not damp rigid motion.
  const Step elastic({{"type", "rayleigh"}, {"stiffness", 0.01}});
  const Points moved = elastic.x_n.colwise() + Eigen::Vector3d(1, 2, 3);
  CHECK(elastic.at(moved).gradient.norm() < 1e-11 * elastic.at(elastic.x).gradient.norm());
}

TEST_CASE("forces leave pads alone") {
  for (const Json& json : {Json{{"type", "gravity"}}, Json{{"type", "drag"}, {"wind", {1, 1, 1}}},
                           Json{{"type", "rayleigh"}, {"mass", 1}, {"stiffness", 1}}}) {
    const Step step(json);
    VertexField gradient(step.groups);
    StrandBands bands(step.groups);
    const VertexField field = positions_with_pads(step.groups, columns(step.x));
    step.force->add(0, field.group(0), {gradient.group(0), bands.group(0)});
    for (int row = 0; row < step.groups.rows(); ++row) {
      for (int lane = 0; lane < lane_count; ++lane) {
        if (step.groups.vertex_at(row, lane) >= 0) continue;
        REQUIRE(gradient.rows()[row].y[lane] == 0);
        for (const Pack& entry : bands.block(row, 0).m) REQUIRE(entry[lane] == 0);
      }
    }
  }
}
