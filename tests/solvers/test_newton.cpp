#include <limits>
#include <sstream>
#include <stdexcept>

#include "core/stiffest_vertex.h"
#include "solvers/newton.h"
#include "tests/catch.h"
#include "tests/solvers/random_system.h"
#include "tests/solvers/test_model.h"

using namespace ringlet;

namespace {

/// Inertia hardly matters over so long a step, so that the energies decide.
constexpr double long_step = 1;

StepReport minimise(Model& model, const NewtonParameters& parameters, State& state, double dt) {
  Newton newton(parameters);
  newton.bind(model);
  const VertexField target = state.positions;
  StepReport report;
  IncrementalPotential potential(model, target, dt);
  newton.minimise(model, potential, dt, state.positions, report);
  return report;
}

/// s (sqrt(1 + |x|^2 / s^2) - 1): Newton's method overshoots ever more from |x| > s.
PointValue pseudo_huber(const Eigen::Vector3d& x, double s) {
  const double root = std::sqrt(1 + x.squaredNorm() / (s * s));
  const Eigen::Vector3d gradient = x / (s * root);
  return {s * (root - 1), gradient,
          Eigen::Matrix3d::Identity() / (s * root) - gradient * gradient.transpose() / (s * root)};
}

/// (|x|^2 - 1)^2 / 4, whose Hessian is indefinite within the unit sphere.
PointValue double_well(const Eigen::Vector3d& x) {
  const double u = x.squaredNorm() - 1;
  return {u * u / 4, u * x, u * Eigen::Matrix3d::Identity() + 2 * x * x.transpose()};
}

double largest_distance_from(const VertexField& field, const Eigen::Vector3d& point) {
  return (field.matrix().colwise() - point).colwise().norm().maxCoeff();
}

}  // namespace

TEST_CASE("Newton solves a quadratic in one iteration") {
  const bool line_search = GENERATE(true, false);
  const auto model = make_model({4, 7, 3, 5, 6, 2, 8, 9, 5}, true);
  add_energy(*model, std::make_unique<Springs>(20));
  add_force(*model, std::make_unique<Weight>(Eigen::Vector3d(1, 2, -9.81)));
  State state = rest_state(*model);
  // The second iteration sees that nothing is left to do.
  const StepReport report = minimise(
      *model, {.newton_iterations = 5, .newton_tolerance = 1e-9, .line_search = line_search}, state,
      0.01);
  CHECK(report.failure.empty());
  CHECK(report.newton_converged);
  CHECK(report.newton_iterations == 2);
  CHECK(report.newton_update < 1e-12);
  CHECK(report.line_search_halvings == 0);
  CHECK(report.linear_converged);
  REQUIRE(report.energies.size() == 1);
  CHECK(report.energies[0] > 0);
}

namespace {

/// Where springs of all strands end under a load that turns them, and the energies there.
std::pair<Eigen::Matrix3Xd, StepReport> end_of_step(const std::string& solver, bool claims_hessian,
                                                    bool line_search) {
  const auto model = make_model({4, 7, 3, 5, 6, 2, 8, 9, 5, 21}, true);
  add_energy(*model, std::make_unique<Springs>(20));
  add_force(*model, std::make_unique<Weight>(Eigen::Vector3d(1, 2, -9.81), claims_hessian));
  add_force(*model, std::make_unique<Weight>(Eigen::Vector3d(0.1, 0, 0)));
  model->solver = make_solver(Json(solver));
  model->solver->bind(model->groups);
  State state = rest_state(*model);
  const NewtonParameters parameters{.newton_iterations = 3, .line_search = line_search};
  StepReport report = minimise(*model, parameters, state, long_step);
  return {state.positions.matrix(), std::move(report)};
}

}  // namespace

TEST_CASE("a step is the same, whether rows or whole strands are completed and solved") {
  const bool line_search = GENERATE(true, false);
  const auto [rows, in_rows] = end_of_step("strand_cholesky", false, line_search);
  const auto [strands, in_strands] = end_of_step("strand_cholesky", true, line_search);
  const auto [all, in_all] = end_of_step("cholesky", false, line_search);
  REQUIRE(in_rows.failure.empty());
  CHECK(rows == strands);
  CHECK(in_rows.energies == in_strands.energies);
  CHECK(in_rows.newton_update == in_strands.newton_update);
  CHECK((rows - all).norm() <= 1e-12 * all.norm());
  CHECK(in_rows.energies[0] == Approx(in_all.energies[0]));
}

namespace {

/// Springs, and a force towards a point above the strands, in which Newton's method overshoots the
/// more the further away they are.
std::unique_ptr<Model> make_drawn_model(const std::vector<int>& lengths,
                                        const std::string& solver) {
  auto model = make_model(lengths, true);
  add_energy(*model, std::make_unique<Springs>(0.05));
  add_force(*model, std::make_unique<PointForce>([](int, const Eigen::Vector3d& x) {
    return pseudo_huber(x - Eigen::Vector3d(0, 0, 1), 0.2);
  }));
  model->solver = make_solver(Json(solver));
  model->solver->bind(model->groups);
  return model;
}

constexpr NewtonParameters until_solved{.newton_iterations = 200, .newton_tolerance = 1e-9};

}  // namespace

TEST_CASE("strands that nothing couples are solved as if there were no others") {
  // Strands of one length fill a group.
  const std::vector<int> short_strands(lane_count, 3), long_strands(lane_count, 12);
  std::vector<int> all = long_strands;
  all.insert(all.end(), short_strands.begin(), short_strands.end());
  const auto solved = [](const std::vector<int>& lengths, const Eigen::Matrix3Xd& start) {
    const auto model = make_drawn_model(lengths, "strand_cholesky");
    State state = rest_state(*model);
    for (int v = 0; v < start.cols(); ++v) state.positions.set(v, start.col(v));
    const StepReport report = minimise(*model, until_solved, state, long_step);
    REQUIRE(report.newton_converged);
    return std::pair(state.positions.matrix(), report);
  };
  // Strands stand side by side by their number, so that only the first ones stand in the same place
  // in both models. They begin near where they end.
  Eigen::Matrix3Xd near_end = solved(long_strands, {}).first;
  near_end.row(2).array() += 1e-3;
  const auto [together, of_all] = solved(all, near_end);
  const auto [alone, of_one] = solved(long_strands, near_end);
  CHECK(together.leftCols(alone.cols()) == alone);
  CHECK(of_all.newton_iterations > of_one.newton_iterations);
  CHECK(of_all.line_search_halvings > of_one.line_search_halvings);
  CHECK(of_all.energies[0] > of_one.energies[0]);
}

TEST_CASE("auto tells that every group was solved by itself") {
  const auto model = make_drawn_model({4, 7}, "auto");
  State state = rest_state(*model);
  minimise(*model, until_solved, state, long_step);
  CHECK(model->solver->account() ==
        "every system by the factors of its strands: nothing couples any");
}

TEST_CASE("strands are solved to the same end one group at a time and all at once") {
  const std::vector<int> lengths = {4, 7, 3, 5, 6, 2, 8, 9, 5, 21};
  const auto solved = [&](const std::string& solver) {
    const auto model = make_drawn_model(lengths, solver);
    State state = rest_state(*model);
    const StepReport report = minimise(*model, until_solved, state, long_step);
    REQUIRE(report.newton_converged);
    return std::pair(state.positions.matrix(), report.energies[0]);
  };
  const auto [separate, separate_energy] = solved("strand_cholesky");
  const auto [coupled, coupled_energy] = solved("cholesky");
  CHECK((separate - coupled).cwiseAbs().maxCoeff() < 1e-8);
  CHECK(separate_energy == Approx(coupled_energy));
}

TEST_CASE("where no step lets the potential fall, the energies are those where x stays") {
  const std::string solver = GENERATE("strand_cholesky", "cholesky");
  const auto model = make_model({4}, false);
  add_energy(*model, std::make_unique<Springs>(20));
  State state = rest_state(*model);
  state.positions.set(3, state.positions.get(3) + Eigen::Vector3d(0, 0, 0.5));
  const Eigen::Matrix3Xd start = state.positions.matrix();
  // As much more as no spring can give back, for any other place.
  add_force(*model, std::make_unique<PointForce>([&start](int vertex, const Eigen::Vector3d& x) {
    const double value = x == start.col(vertex) ? 0 : 1e6;
    return PointValue{value, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero()};
  }));
  model->solver = make_solver(Json(solver));
  model->solver->bind(model->groups);
  const double energy = model->energies[0]->add(0, state.positions.group(0), {});
  const StepReport report = minimise(*model, {}, state, long_step);
  CHECK(report.failure.empty());
  CHECK_FALSE(report.newton_converged);
  CHECK(report.line_search_halvings > 0);
  CHECK(state.positions.matrix() == start);
  REQUIRE(energy > 0);
  CHECK(report.energies[0] == Approx(energy));
}

TEST_CASE("nothing to do is done at once") {
  const auto model = make_model({4, 7}, true);
  add_energy(*model, std::make_unique<Springs>(20));
  State state = rest_state(*model);
  const Eigen::Matrix3Xd before = state.positions.matrix();
  const StepReport report = minimise(*model, {}, state, 0.01);
  CHECK(report.newton_converged);
  CHECK(report.newton_iterations == 1);
  CHECK((state.positions.matrix() - before).cwiseAbs().maxCoeff() < 1e-15);
}

TEST_CASE("the line search tames an overshooting update") {
  const auto model = make_model({4, 4}, false);
  add_force(*model, std::make_unique<PointForce>([](int, const Eigen::Vector3d& x) {
    return pseudo_huber(x - Eigen::Vector3d(0, 0, 1), 0.2);
  }));
  State state = rest_state(*model);
  const StepReport tamed =
      minimise(*model, {.newton_iterations = 50, .newton_tolerance = 1e-12, .line_search = true},
               state, long_step);
  CHECK(tamed.failure.empty());
  CHECK(tamed.newton_converged);
  CHECK(tamed.line_search_halvings > 0);
  CHECK(largest_distance_from(state.positions, {0, 0, 1}) < 1e-6);

  State wild = rest_state(*model);
  const StepReport untamed =
      minimise(*model, {.newton_iterations = 50, .newton_tolerance = 1e-12, .line_search = false},
               wild, long_step);
  CHECK_FALSE((untamed.failure.empty() && untamed.newton_converged));
}

TEST_CASE("an indefinite Hessian is made definite with mass") {
  const auto model = make_model({4, 5}, false);
  add_force(*model, std::make_unique<PointForce>(
                        [](int, const Eigen::Vector3d& x) { return double_well(x); }));
  for (const char* solver : {"strand_cholesky", "cholesky", "pcg", "jacobi"}) {
    INFO(solver);
    model->solver = make_solver(solver);
    model->solver->bind(model->groups);
    State state = rest_state(*model);
    for (int v = 0; v < 9; ++v) state.positions.set(v, {0.1, 0.02 * v, -0.05});
    const StepReport report =
        minimise(*model, {.newton_iterations = 100, .newton_tolerance = 1e-11, .line_search = true},
                 state, long_step);
    CHECK(report.failure.empty());
    CHECK(report.newton_converged);
    for (int v = 0; v < 9; ++v) CHECK(state.positions.get(v).norm() == Approx(1));
  }
}

TEST_CASE("a value that is not finite is never accepted") {
  const auto model = make_model({4, 4}, false);
  // A slope towards a cliff at z = 1: NaN behind it.
  add_force(*model, std::make_unique<PointForce>([](int, const Eigen::Vector3d& x) {
    const double value = x.z() < 1 ? -x.z() : std::numeric_limits<double>::quiet_NaN();
    return PointValue{value, -Eigen::Vector3d::UnitZ(), Eigen::Matrix3d::Zero()};
  }));
  State state = rest_state(*model);
  const StepReport report = minimise(*model, {.newton_iterations = 20}, state, long_step);
  CHECK(report.failure.empty());
  CHECK_FALSE(report.newton_converged);
  CHECK(report.line_search_halvings > 0);
  CHECK(state.positions.matrix().row(2).maxCoeff() < 1);
  CHECK(state.positions.matrix().row(2).maxCoeff() > 0.5);

  State unguarded = rest_state(*model);
  const StepReport failed =
      minimise(*model, {.newton_iterations = 20, .line_search = false}, unguarded, long_step);
  CHECK_THAT(failed.failure, Catch::Contains("force 0"));
}

TEST_CASE("a failure says what and where") {
  const auto model = make_model({4, 6}, false);
  add_energy(*model, std::make_unique<Springs>(20));
  add_force(*model, std::make_unique<PointForce>([](int vertex, const Eigen::Vector3d&) {
    const double value = vertex == 7 ? std::numeric_limits<double>::quiet_NaN() : 0;
    return PointValue{0, Eigen::Vector3d::Constant(value), Eigen::Matrix3d::Zero()};
  }));
  State state = rest_state(*model);
  const StepReport report = minimise(*model, {}, state, 0.01);
  CHECK_THAT(report.failure, Catch::Contains("Newton iteration 1") &&
                                 Catch::Contains("'force 0'") &&
                                 Catch::Contains("strand 1, vertex 3"));
  CHECK_FALSE(report.newton_converged);
}

TEST_CASE("a failure of one group among many is told") {
  const auto model = make_model(std::vector<int>(5 * lane_count, 4), false);
  add_energy(*model, std::make_unique<Springs>(20));
  constexpr int wrong = 4 * (3 * lane_count + 1) + 2;
  add_force(*model, std::make_unique<PointForce>([](int vertex, const Eigen::Vector3d&) {
    const double value = vertex == wrong ? std::numeric_limits<double>::infinity() : 0;
    return PointValue{value, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero()};
  }));
  State state = rest_state(*model);
  const StepReport report = minimise(*model, {}, state, 0.01);
  CHECK_THAT(report.failure, Catch::Contains("Newton iteration 1: the value of 'force 0'"));
  CHECK_FALSE(report.newton_converged);
}

TEST_CASE("a gradient that lies is not followed") {
  const auto model = make_model({4}, false);
  add_force(*model, std::make_unique<PointForce>([](int, const Eigen::Vector3d& x) {
    return PointValue{x.z(), -Eigen::Vector3d::UnitZ(), Eigen::Matrix3d::Zero()};
  }));
  State state = rest_state(*model);
  const Eigen::Matrix3Xd before = state.positions.matrix();
  const StepReport report = minimise(*model, {}, state, 0.01);
  CHECK(report.failure.empty());
  CHECK_FALSE(report.newton_converged);
  CHECK(report.newton_iterations == 1);
  CHECK(state.positions.matrix() == before);
}

TEST_CASE("the iteration cap is reported") {
  const auto model = make_model({4, 4}, false);
  add_force(*model, std::make_unique<PointForce>([](int, const Eigen::Vector3d& x) {
    return pseudo_huber(x - Eigen::Vector3d(0, 0, 1), 0.2);
  }));
  State state = rest_state(*model);
  const StepReport report =
      minimise(*model, {.newton_iterations = 2, .newton_tolerance = 1e-12}, state, long_step);
  CHECK(report.newton_iterations == 2);
  CHECK_FALSE(report.newton_converged);
  CHECK(report.newton_update > 0);
}

TEST_CASE("an exception of an energy is told with the name of the energy") {
  class Failing final : public Energy {
   public:
    void bind(const Strands&, const StrandGroups&) override {}
    double add(int, std::span<const Vector3<Pack>>, EdgeOutputs) const override {
      throw std::runtime_error("out of luck");
    }
  };
  const auto model = make_model({4, 7}, true);
  add_energy(*model, std::make_unique<Failing>());
  State state = rest_state(*model);
  const std::string expected = "energy '" + model->energies[0]->name() + "': out of luck";
  CHECK_THROWS_WITH(minimise(*model, {}, state, 0.01), expected);
}

TEST_CASE("the stiffest vertex is named with its energy, and how stiff it is") {
  const auto model = make_model({3, 6}, true);
  add_energy(*model, std::make_unique<Springs>(1e-3));
  add_energy(*model, std::make_unique<Springs>(4e6));
  const State state = rest_state(*model);
  const auto text = describe_stiffest_vertex(*model, state.positions, 1);
  REQUIRE(text);
  // Two springs at every inner vertex, and half the mass of those at the tips.
  const double ratio = 3 * 2 * 4e6 / model->strands.mass(1);
  std::ostringstream expected;
  expected.precision(2);
  expected << ratio << " times as stiffly";
  CHECK_THAT(*text, Catch::Contains("'energy 1' holds strand") && Catch::Contains(expected.str()));
  CHECK_FALSE(describe_stiffest_vertex(*make_model({3}, true), state.positions, 1));
}
