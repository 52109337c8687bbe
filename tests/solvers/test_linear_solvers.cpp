#include <tbb/global_control.h>

#include <limits>

#include "tests/catch.h"
#include "tests/solvers/random_system.h"

using namespace ringlet;

namespace {

const std::vector<int> lengths{5, 9, 2, 14, 3, 4, 7, 8, 20, 6, 11};

std::vector<Json> exact_solvers() {
  return {Json{{"type", "cholesky"}},
          Json{{"type", "jacobi"}, {"tolerance", 1e-10}, {"max_iterations", 100000}},
          Json{{"type", "pcg"}, {"tolerance", 1e-10}},
          Json{{"type", "pcg"}, {"tolerance", 1e-10}, {"preconditioner", "jacobi"}},
          Json{{"type", "pcg"}, {"tolerance", 1e-10}, {"preconditioner", "cholesky"}},
          Json{{"type", "pcg"}, {"tolerance", 1e-10}, {"preconditioner", "none"}}};
}

void check_solution(const Json& json, const RandomSystem& system) {
  INFO(json.dump());
  const auto solver = make_solver(json);
  solver->bind(system.groups);
  REQUIRE(prepare(*solver, system.matrix));
  const VertexField b = system.right_hand_side(7);
  VertexField x(system.groups);
  for (auto& row : x.rows()) row = {Pack(3), Pack(4), Pack(5)};  // an old solution
  const SolveReport report = solver->solve(b, x);
  CHECK(report.converged);
  CHECK(report.residual <= 1e-10);
  const Eigen::Matrix3Xd expected = RandomSystem::dense_solution(system.dense, b);
  CHECK(relative_difference(x.matrix(), expected) < 1e-8);

  for (int row = 0; row < system.groups.rows(); ++row) {
    for (int lane = 0; lane < lane_count; ++lane) {
      if (system.groups.vertex_at(row, lane) < 0) CHECK(x.rows()[row].x[lane] == 0);
    }
  }
}

Matrix3<Pack>& last_diagonal_block(RandomSystem& system, int vertex) {
  const int group = system.groups.group_of(vertex);
  return system.matrix.bands.group(group).block(
      system.groups.slot(vertex).row - system.groups[group].first_row, 0);
}

}  // namespace

TEST_CASE("every solver solves a system without couplings") {
  const RandomSystem system(lengths, 0, 1);
  check_solution({{"type", "strand_cholesky"}}, system);
  for (const Json& json : exact_solvers()) check_solution(json, system);
}

TEST_CASE("every solver but strand_cholesky solves a system with couplings") {
  const unsigned seed = GENERATE(11u, 12u, 13u);
  const RandomSystem system(lengths, 40, seed);
  for (const Json& json : exact_solvers()) check_solution(json, system);
}

TEST_CASE("strand_cholesky says that it leaves couplings out, and solves with the bands") {
  const RandomSystem system(lengths, 40, 2);
  const auto solver = make_solver("strand_cholesky");
  solver->bind(system.groups);
  REQUIRE(prepare(*solver, system.matrix));
  const VertexField b = system.right_hand_side(3);
  VertexField x(system.groups), residual(system.groups);
  const SolveReport report = solver->solve(b, x);
  CHECK_FALSE(report.converged);
  multiply(system.matrix, x, residual);
  add_scaled(residual, -1, b);
  CHECK(report.residual == Approx(std::sqrt(dot(residual, residual) / dot(b, b))));
  CHECK(report.residual > 1e-3);
  const Eigen::Matrix3Xd expected = RandomSystem::dense_solution(system.dense_bands, b);
  CHECK(relative_difference(x.matrix(), expected) < 1e-10);
}

TEST_CASE("an exact preconditioner needs one iteration, and a better one fewer than a worse") {
  const RandomSystem system(lengths, 40, 4);
  const VertexField b = system.right_hand_side(5);
  VertexField x(system.groups);
  const auto iterations = [&](const Json& preconditioner) {
    const auto solver = make_solver({{"type", "pcg"}, {"preconditioner", preconditioner}});
    solver->bind(system.groups);
    REQUIRE(prepare(*solver, system.matrix));
    return solver->solve(b, x).iterations;
  };
  CHECK(iterations("cholesky") == 1);
  CHECK(iterations("strand_cholesky") < iterations("jacobi"));
}

TEST_CASE("a right-hand side of zero has the solution zero") {
  const RandomSystem system(lengths, 10, 6);
  std::vector<Json> all = exact_solvers();
  for (const Json& json : all) {
    INFO(json.dump());
    const auto solver = make_solver(json);
    solver->bind(system.groups);
    REQUIRE(prepare(*solver, system.matrix));
    VertexField x = system.right_hand_side(1);
    const SolveReport report = solver->solve(VertexField(system.groups), x);
    CHECK(report.converged);
    CHECK(report.residual == 0);
    CHECK(dot(x, x) == 0);
  }
}

TEST_CASE("a matrix that is not positive definite, or not finite, is refused") {
  const int vertex = GENERATE(0, 8, 30, 60, 88);
  const double pivot = GENERATE(-1e9, std::numeric_limits<double>::quiet_NaN(),
                                std::numeric_limits<double>::infinity());
  RandomSystem system(lengths, 5, 8);
  REQUIRE(vertex < system.strands.vertex_count());
  last_diagonal_block(system, vertex)(2, 2)[system.groups.slot(vertex).lane] = pivot;
  for (const Json& json :
       {Json("strand_cholesky"), Json("cholesky"), Json("jacobi"), Json("pcg")}) {
    INFO(json.dump() << " vertex " << vertex << " pivot " << pivot);
    const auto solver = make_solver(json);
    solver->bind(system.groups);
    CHECK_FALSE(prepare(*solver, system.matrix));
  }
}

TEST_CASE("a matrix that is indefinite only as a whole is refused by the strands' factors") {
  RandomSystem system({8, 8}, 0, 9);
  // A block off the diagonal too large for the diagonal ones, which stay positive.
  GroupBands bands = system.matrix.bands.group(0);
  bands.block(5, 1)(0, 0)[0] = 1e3;
  for (const auto& [name, accepted] : {std::pair("strand_cholesky", false), {"jacobi", true}}) {
    const auto solver = make_solver(name);
    solver->bind(system.groups);
    CHECK(prepare(*solver, system.matrix) == accepted);
  }
}

TEST_CASE("conjugate gradients notice an indefinite matrix and stay finite") {
  RandomSystem system({8, 8}, 0, 9);
  system.matrix.bands.group(0).block(5, 1)(0, 0)[0] = 1e3;
  for (const Json& preconditioner : {Json("jacobi"), Json(nullptr)}) {
    const auto solver = make_solver({{"type", "pcg"}, {"preconditioner", preconditioner}});
    solver->bind(system.groups);
    REQUIRE(prepare(*solver, system.matrix));
    VertexField x(system.groups);
    const SolveReport report = solver->solve(system.right_hand_side(1), x);
    CHECK_FALSE(report.converged);
    CHECK(x.matrix().allFinite());
  }
}

TEST_CASE("an iteration cap that is hit is reported") {
  const RandomSystem system(lengths, 40, 10);
  for (const Json& json : {Json{{"type", "pcg"}, {"max_iterations", 3}},
                           Json{{"type", "jacobi"}, {"max_iterations", 3}}}) {
    INFO(json.dump());
    const auto solver = make_solver(json);
    solver->bind(system.groups);
    REQUIRE(prepare(*solver, system.matrix));
    VertexField x(system.groups);
    const SolveReport report = solver->solve(system.right_hand_side(1), x);
    CHECK(report.iterations == 3);
    CHECK_FALSE(report.converged);
    CHECK(report.residual > 1e-6);
    CHECK(report.residual < 1);
    CHECK(dot(x, x) > 0);
  }
}

TEST_CASE("a Jacobi iteration that diverges stops before it grows") {
  const RandomSystem system(lengths, 40, 10);
  const auto solver = make_solver({{"type", "jacobi"}, {"weight", 1.5}});
  solver->bind(system.groups);
  REQUIRE(prepare(*solver, system.matrix));
  VertexField x(system.groups);
  const SolveReport report = solver->solve(system.right_hand_side(1), x);
  CHECK_FALSE(report.converged);
  CHECK(report.iterations < 1000);
  CHECK(report.residual <= 1);
  CHECK(x.matrix().allFinite());
}

TEST_CASE("a solver may be used for one matrix after another") {
  const RandomSystem loose(lengths, 0, 20), tied(lengths, 40, 20), tied_otherwise(lengths, 40, 21);
  for (const Json& json : exact_solvers()) {
    INFO(json.dump());
    const auto solver = make_solver(json);
    solver->bind(loose.groups);
    for (const RandomSystem* system : {&loose, &tied, &tied_otherwise, &loose}) {
      REQUIRE(prepare(*solver, system->matrix));
      const VertexField b = system->right_hand_side(3);
      VertexField x(system->groups);
      CHECK(solver->solve(b, x).converged);
      const Eigen::Matrix3Xd expected = RandomSystem::dense_solution(system->dense, b);
      CHECK(relative_difference(x.matrix(), expected) < 1e-8);
    }
  }
}

TEST_CASE("the bits of a solution do not depend on the number of threads") {
  const std::vector<int> many(100, 12);
  const auto solve = [&](const Json& json, std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const RandomSystem system(many, 60, 30);
    const auto solver = make_solver(json);
    solver->bind(system.groups);
    REQUIRE(prepare(*solver, system.matrix));
    VertexField x(system.groups);
    solver->solve(system.right_hand_side(31), x);
    return x.matrix();
  };
  for (const Json& json :
       {Json("strand_cholesky"), Json("pcg"), Json{{"type", "jacobi"}, {"max_iterations", 20}}}) {
    INFO(json.dump());
    const Eigen::Matrix3Xd alone = solve(json, 1);
    for (int repetition = 0; repetition < 3; ++repetition) CHECK(solve(json, 4) == alone);
  }
}
