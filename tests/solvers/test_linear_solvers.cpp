#include <tbb/global_control.h>

#include <limits>

#include "tests/catch.h"
#include "tests/solvers/random_system.h"

using namespace ringlet;

namespace {

std::vector<Json> exact_solvers() {
  return {Json{{"type", "cholesky"}},
          Json{{"type", "jacobi"}, {"tolerance", 1e-10}, {"max_iterations", 100000}},
          Json{{"type", "pcg"}, {"tolerance", 1e-10}},
          Json{{"type", "auto"}, {"coupled", {{"type", "pcg"}, {"tolerance", 1e-10}}}},
          Json{{"type", "pcg"}, {"tolerance", 1e-10}, {"preconditioner", "jacobi"}},
          Json{{"type", "pcg"}, {"tolerance", 1e-10}, {"preconditioner", "cholesky"}},
          Json{{"type", "pcg"}, {"tolerance", 1e-10}, {"preconditioner", "none"}}};
}

void check_solution(const Json& json, const RandomSystem& system) {
  INFO(json.dump());
  const auto solver = make_solver(json);
  const VertexField b = system.right_hand_side(7);
  Prepared prepared(*solver, system.matrix, b);
  REQUIRE(prepared.accepted());
  const SolveReport report = prepared.solve();
  const VertexField& x = prepared.solution();
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
  const RandomSystem system(mixed_lengths, 0, 1);
  check_solution({{"type", "strand_cholesky"}}, system);
  for (const Json& json : exact_solvers()) check_solution(json, system);
}

TEST_CASE("every solver but strand_cholesky solves a system with couplings") {
  const unsigned seed = GENERATE(11u, 12u, 13u);
  const RandomSystem system(mixed_lengths, 40, seed);
  for (const Json& json : exact_solvers()) check_solution(json, system);
}

TEST_CASE("conjugate gradients are as exact as their tolerance asks for") {
  const RandomSystem system(mixed_lengths, 40, 14);
  const VertexField b = system.right_hand_side(7);
  const Eigen::Matrix3Xd expected = RandomSystem::dense_solution(system.dense, b);
  const auto energy_norm = [&](const Eigen::Matrix3Xd& x) {
    return std::sqrt(x.reshaped().dot(system.dense * x.reshaped()));
  };
  for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-9}) {
    INFO(tolerance);
    const auto solver = make_solver({{"type", "pcg"}, {"tolerance", tolerance}});
    Prepared prepared(*solver, system.matrix, b);
    REQUIRE(prepared.accepted());
    CHECK(prepared.solve().converged);
    const Eigen::Matrix3Xd error = prepared.solution().matrix() - expected;
    CHECK(energy_norm(error) < 10 * tolerance * energy_norm(expected));
  }
}

TEST_CASE("strand_cholesky says that it leaves couplings out, and solves with the bands") {
  const RandomSystem system(mixed_lengths, 40, 2);
  const auto solver = make_solver("strand_cholesky");
  const VertexField b = system.right_hand_side(3);
  Prepared prepared(*solver, system.matrix, b);
  REQUIRE(prepared.accepted());
  const SolveReport report = prepared.solve();
  const VertexField& x = prepared.solution();
  VertexField residual(system.groups);
  CHECK_FALSE(report.converged);
  multiply(system.matrix, x, residual);
  add_scaled(residual, -1, b);
  CHECK(report.residual == Approx(std::sqrt(dot(residual, residual) / dot(b, b))));
  CHECK(report.residual > 1e-3);
  const Eigen::Matrix3Xd expected = RandomSystem::dense_solution(system.dense_bands, b);
  CHECK(relative_difference(x.matrix(), expected) < 1e-10);
}

TEST_CASE("an exact preconditioner needs one iteration, and a better one fewer than a worse") {
  const RandomSystem system(mixed_lengths, 40, 4);
  const VertexField b = system.right_hand_side(5);
  const auto iterations = [&](const Json& preconditioner) {
    const auto solver = make_solver({{"type", "pcg"}, {"preconditioner", preconditioner}});
    Prepared prepared(*solver, system.matrix, b);
    REQUIRE(prepared.accepted());
    return prepared.solve().iterations;
  };
  CHECK(iterations("cholesky") == 1);
  CHECK(iterations("strand_cholesky") < iterations("jacobi"));
}

TEST_CASE("a right-hand side of zero has the solution zero") {
  const RandomSystem system(mixed_lengths, 10, 6);
  std::vector<Json> all = exact_solvers();
  for (const Json& json : all) {
    INFO(json.dump());
    const auto solver = make_solver(json);
    Prepared prepared(*solver, system.matrix, VertexField(system.groups));
    REQUIRE(prepared.accepted());
    const SolveReport report = prepared.solve();
    CHECK(report.converged);
    CHECK(report.residual == 0);
    CHECK(dot(prepared.solution(), prepared.solution()) == 0);
  }
}

TEST_CASE("a matrix that is not positive definite, or not finite, is refused") {
  const int vertex = GENERATE(0, 8, 30, 60, 88);
  const double pivot = GENERATE(-1e9, std::numeric_limits<double>::quiet_NaN(),
                                std::numeric_limits<double>::infinity());
  RandomSystem system(mixed_lengths, 5, 8);
  REQUIRE(vertex < system.strands.vertex_count());
  last_diagonal_block(system, vertex)(2, 2)[system.groups.slot(vertex).lane] = pivot;
  for (const Json& json :
       {Json("strand_cholesky"), Json("cholesky"), Json("jacobi"), Json("pcg")}) {
    INFO(json.dump() << " vertex " << vertex << " pivot " << pivot);
    const auto solver = make_solver(json);
    CHECK_FALSE(Prepared(*solver, system.matrix, system.right_hand_side(1)).accepted());
  }
}

TEST_CASE("a matrix that is indefinite only as a whole is refused by the strands' factors") {
  RandomSystem system({8, 8}, 0, 9);
  // A block off the diagonal too large for the diagonal ones, which stay positive.
  GroupBands bands = system.matrix.bands.group(0);
  bands.block(5, 1)(0, 0)[0] = 1e3;
  for (const auto& [name, accepted] : {std::pair("strand_cholesky", false), {"jacobi", true}}) {
    const auto solver = make_solver(name);
    const Prepared prepared(*solver, system.matrix, system.right_hand_side(1));
    CHECK(prepared.accepted() == accepted);
  }
}

TEST_CASE("conjugate gradients notice an indefinite matrix and stay finite") {
  RandomSystem system({8, 8}, 0, 9);
  system.matrix.bands.group(0).block(5, 1)(0, 0)[0] = 1e3;
  for (const Json& preconditioner : {Json("jacobi"), Json(nullptr)}) {
    const auto solver = make_solver({{"type", "pcg"}, {"preconditioner", preconditioner}});
    Prepared prepared(*solver, system.matrix, system.right_hand_side(1));
    REQUIRE(prepared.accepted());
    const SolveReport report = prepared.solve();
    CHECK_FALSE(report.converged);
    CHECK(prepared.solution().matrix().allFinite());
  }
}

TEST_CASE("an iteration cap that is hit is reported") {
  const RandomSystem system(mixed_lengths, 40, 10);
  for (const Json& json : {Json{{"type", "pcg"}, {"max_iterations", 3}},
                           Json{{"type", "jacobi"}, {"max_iterations", 3}}}) {
    INFO(json.dump());
    const auto solver = make_solver(json);
    Prepared prepared(*solver, system.matrix, system.right_hand_side(1));
    REQUIRE(prepared.accepted());
    const SolveReport report = prepared.solve();
    CHECK(report.iterations == 3);
    CHECK_FALSE(report.converged);
    CHECK(report.residual > 1e-6);
    CHECK(report.residual < 1);
    CHECK(dot(prepared.solution(), prepared.solution()) > 0);
  }
}

TEST_CASE("a Jacobi iteration that diverges stops before it grows") {
  const RandomSystem system(mixed_lengths, 40, 10);
  const auto solver = make_solver({{"type", "jacobi"}, {"weight", 1.5}});
  Prepared prepared(*solver, system.matrix, system.right_hand_side(1));
  REQUIRE(prepared.accepted());
  const SolveReport report = prepared.solve();
  CHECK_FALSE(report.converged);
  CHECK(report.iterations < 1000);
  CHECK(report.residual <= 1);
  CHECK(prepared.solution().matrix().allFinite());
}

TEST_CASE("a solver may be used for one matrix after another") {
  const RandomSystem loose(mixed_lengths, 0, 20), tied(mixed_lengths, 40, 20),
      tied_otherwise(mixed_lengths, 40, 21);
  for (const Json& json : exact_solvers()) {
    INFO(json.dump());
    const auto solver = make_solver(json);
    for (const RandomSystem* system : {&loose, &tied, &tied_otherwise, &loose}) {
      const VertexField b = system->right_hand_side(3);
      Prepared prepared(*solver, system->matrix, b);
      REQUIRE(prepared.accepted());
      CHECK(prepared.solve().converged);
      const Eigen::Matrix3Xd expected = RandomSystem::dense_solution(system->dense, b);
      CHECK(relative_difference(prepared.solution().matrix(), expected) < 1e-8);
    }
  }
}

TEST_CASE("strands that nothing couples are solved without iterations, beside those that are") {
  // Two groups of eight; contacts between strands of the first one only.
  const RandomSystem loose(std::vector<int>(16, 9), 0, 50), tied(std::vector<int>(16, 9), 40, 50);
  const auto solver = make_solver({{"type", "pcg"}, {"tolerance", 1e-10}});
  Prepared prepared(*solver, loose.matrix, loose.right_hand_side(1));
  CHECK(prepared.solve().iterations == 0);
  const Eigen::Matrix3Xd expected =
      RandomSystem::dense_solution(loose.dense, loose.right_hand_side(1));
  CHECK(relative_difference(prepared.solution().matrix(), expected) < 1e-10);
  CHECK(Prepared(*solver, tied.matrix, tied.right_hand_side(1)).solve().iterations > 0);
}

TEST_CASE("auto tells what it chose, and why") {
  const RandomSystem loose(mixed_lengths, 0, 20), tied(mixed_lengths, 40, 20);
  const auto solver = make_solver("auto");
  CHECK(solver->account().empty());
  for (const RandomSystem* system : {&loose, &tied, &tied}) {
    Prepared prepared(*solver, system->matrix, system->right_hand_side(3));
    CHECK((prepared.solve().iterations > 0) == system->matrix.couples_strands());
  }
  CHECK(solver->account() ==
        "1 systems by the factors of their strands: no contact coupled any; 2 systems by pcg: "
        "contacts coupled strands");
}

TEST_CASE("the bits of a solution do not depend on the number of threads") {
  const std::vector<int> many(100, 12);
  const auto solve = [&](const Json& json, std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const RandomSystem system(many, 60, 30);
    const auto solver = make_solver(json);
    Prepared prepared(*solver, system.matrix, system.right_hand_side(31));
    REQUIRE(prepared.accepted());
    prepared.solve();
    return prepared.solution().matrix();
  };
  for (const Json& json :
       {Json("strand_cholesky"), Json("pcg"), Json{{"type", "jacobi"}, {"max_iterations", 20}}}) {
    INFO(json.dump());
    const Eigen::Matrix3Xd alone = solve(json, 1);
    for (int repetition = 0; repetition < 3; ++repetition) CHECK(solve(json, 4) == alone);
  }
}
