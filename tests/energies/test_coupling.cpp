#include "core/batch_coupling.h"
#include "core/modules.h"
#include "core/simulation.h"
#include "core/system_matrix.h"
#include "core/verify/shapes.h"
#include "energies/modules.h"
#include "solvers/modules.h"
#include "tests/catch.h"

using namespace ringlet;

namespace {

/// Ties each vertex of the first strand to the vertex of the same number of the second by a spring.
struct Ties {
  struct Parameters {
    Varying stiffness = 10.0;
    static Schema<Parameters> schema() {
      return Schema<Parameters>().key("stiffness", &Parameters::stiffness, "N/m", positive(),
                                      "of each spring");
    }
  };
  static constexpr int vertices = 2;
  template <class S>
  struct Rest {
    S stiffness;
  };
  Parameters parameters;

  std::vector<std::array<int, 2>> tuples(const Strands& strands) const {
    std::vector<std::array<int, 2>> pairs;
    for (int i = 0; i < strands.size(0); ++i) pairs.push_back({i, strands.first(1) + i});
    return pairs;
  }
  Rest<double> rest(const TupleRest<2>& tuple) const {
    return {parameters.stiffness.at(tuple.strands, tuple.vertices[1])};
  }
  template <class S>
  S value(const Stencil<S, 2>& x, const Rest<S>& rest) const {
    return S(0.5) * rest.stiffness * squared_norm(x[1] - x[0]);
  }
};

/// The volume of the tetrahedron of four vertices of any strands, squared.
struct Volumes {
  using Parameters = NoParameters;
  static constexpr int vertices = 4;
  template <class S>
  struct Rest {
    S stiffness;
  };
  NoParameters parameters;

  std::vector<std::array<int, 4>> tuples(const Strands&) const {
    return {{0, 1, 9, 14}, {3, 10, 4, 12}, {8, 15, 1, 5}, {9, 10, 11, 12}};
  }
  Rest<double> rest(const TupleRest<4>&) const { return {3}; }
  template <class S>
  S value(const Stencil<S, 4>& x, const Rest<S>& rest) const {
    const S volume = dot(x[1] - x[0], cross(x[2] - x[1], x[3] - x[2]));
    return rest.stiffness * volume * volume;
  }
};

struct Bound {
  explicit Bound(Filter filter) : coupling(Volumes{}, filter) { coupling.bind(strands, groups); }

  double value(const Points& x) const {
    return coupling.add(positions_with_pads(groups, columns(x)), nullptr);
  }
  /// Gradient, and the Hessian as the bands and what is beyond them have it, over all vertices.
  std::pair<Eigen::VectorXd, Eigen::MatrixXd> derivatives(const Points& x) const {
    Couplings couplings(groups);
    const double value_beside = coupling.add(positions_with_pads(groups, columns(x)), &couplings);
    CHECK(value_beside == Approx(value(x)));
    couplings.finish(VertexScalars(groups.rows(), Pack(1)));
    VertexField gradient(groups);
    SystemMatrix matrix(groups);
    matrix.keep_bands();
    matrix.couplings = couplings;
    for (int g = 0; g < groups.count(); ++g) {
      couplings.add_gradient(g, gradient.group(g));
      couplings.add_to_bands(g, matrix.bands.group(g));
    }
    const auto size = x.size();
    Eigen::MatrixXd hessian(size, size);
    for (Eigen::Index i = 0; i < size; ++i) {
      VertexField unit(groups), column(groups);
      unit.set(static_cast<int>(i / 3), Eigen::Vector3d::Unit(i % 3));
      multiply(matrix, unit, column);
      hessian.col(i) = column.matrix().reshaped();
    }
    return {gradient.matrix().reshaped(), hessian};
  }

  std::mt19937_64 random{5};
  Points rest = random_points(random, 16);
  Strands strands{{9, 7}, columns(rest), Material{}};
  StrandGroups groups{strands};
  BatchCoupling<Volumes> coupling;
};

Simulation hanging(const std::string& solver, const std::string& stiffness) {
  Registry registry;
  register_core(registry);
  register_energies(registry);
  register_solvers(registry);
  register_coupling<Ties>(registry, "ties", {});
  return Simulation(read_scene(Json::parse(R"({
    "strands": [{"type": "explicit", "pinned": 3, "strands": [[[0, 0, 0], [1, 0, 0], [2, 0, 0]]]},
                {"type": "explicit", "pinned": 0, "strands": [[[0, 0, 0], [1, 0, 0], [2, 0, 0]]]}],
    "material": {"radius": 0.01, "density": 1000},
    "energies": [], "forces": ["gravity"],
    "couplings": [{"type": "ties", "stiffness": )" +
                                           stiffness + R"(}],
    "integrator": {"type": "bdf1", "dt": 1, "newton_tolerance": 1e-9},
    "solver": )" + solver + "}"),
                               registry, "/"));
}

}  // namespace

TEST_CASE("derivatives of a coupling of any vertices are those of its value") {
  const Bound exact(Filter::exact);
  std::mt19937_64 random(6);
  const Points x = random_points(random, 16);
  const auto [gradient, hessian] = exact.derivatives(x);
  REQUIRE(gradient.norm() > 1);
  constexpr double step = 1e-6;
  for (int i = 0; i < x.size(); ++i) {
    Points above = x, below = x;
    above.reshaped()(i) += step;
    below.reshaped()(i) -= step;
    CHECK(gradient(i) ==
          Approx((exact.value(above) - exact.value(below)) / (2 * step)).margin(1e-7));
    const Eigen::VectorXd slope =
        (exact.derivatives(above).first - exact.derivatives(below).first) / (2 * step);
    CHECK((hessian.col(i) - slope).norm() < 1e-6 * hessian.norm());
  }
}

TEST_CASE("the filtered Hessian of a coupling is positive semi-definite") {
  std::mt19937_64 random(7);
  const Points x = random_points(random, 16);
  const Eigen::MatrixXd exact = Bound(Filter::exact).derivatives(x).second;
  REQUIRE(smallest_eigenvalue(exact) < -0.1);
  for (const Filter filter : {Filter::tight, Filter::clamp}) {
    const Eigen::MatrixXd filtered = Bound(filter).derivatives(x).second;
    CHECK(smallest_eigenvalue(filtered) > -1e-10);
    CHECK(smallest_eigenvalue(filtered - exact) > -1e-10);
  }
}

TEST_CASE("a strand tied to another one hangs as far below it as its springs let it") {
  for (const char* solver : {"\"auto\"", "\"cholesky\"", "\"pcg\"", "\"jacobi\""}) {
    Simulation simulation = hanging(solver, R"({"by_vertex": [1, 1, 1, 10, 20, 40]})");
    for (int step = 0; step < 60; ++step) REQUIRE(simulation.step().failure.empty());
    const Strands& strands = simulation.model().strands;
    for (int i = 0; i < 3; ++i) {
      const double stiffness = 10 << i;
      const double sag = strands.mass(3 + i) * 9.81 / stiffness;
      CHECK(simulation.state().positions.get(3 + i).y() == Approx(-sag).epsilon(1e-6));
    }
  }
}

TEST_CASE("couplings have a value in the report of a step") {
  Simulation simulation = hanging("\"auto\"", "10");
  StepReport report;
  for (int step = 0; step < 60; ++step) report = simulation.step();
  const Strands& strands = simulation.model().strands;
  double expected = 0;
  for (int v = 3; v < 6; ++v) expected += std::pow(strands.mass(v) * 9.81, 2) / 20;
  REQUIRE(report.energies.size() == 1);
  CHECK(report.energies[0] == Approx(expected).epsilon(1e-6));
}
