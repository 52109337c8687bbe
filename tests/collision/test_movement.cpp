#include "collision/movement.h"
#include "tests/catch.h"
#include "tests/collision/random_strands.h"

using namespace ringlet;

TEST_CASE("a rigid motion of all points is no movement, that of a single point is") {
  std::mt19937 random(41);
  Points start(5000), moved;
  for (auto& p : start) p = random_point(random, 1);
  const Eigen::Isometry3d turn(Eigen::Translation3d(3, -2, 1) *
                               Eigen::AngleAxisd(2.5, Eigen::Vector3d(1, 2, 3).normalized()));
  for (const auto& p : start) moved.push_back(turn * p);

  Movement movement;
  CHECK(!movement.has_started());
  movement.start_from(start);
  REQUIRE(movement.has_started());
  CHECK(movement.rigid_part(moved).isApprox(turn, 1e-10));
  CHECK(movement.is_within(1e-10, moved, turn));
  CHECK(!movement.is_within(1, moved, Eigen::Isometry3d::Identity()));

  moved[4321] += Eigen::Vector3d(0, 0, 1e-3);
  CHECK(!movement.is_within(0.9e-3, moved, turn));
  CHECK(movement.is_within(1.1e-3, moved, turn));

  moved[17] += Eigen::Vector3d(2e-3, 0, 0);
  moved[18].x() = std::numeric_limits<double>::quiet_NaN();
  CHECK(movement.beyond(0.9e-3, moved, turn) == std::vector<int>{17, 18, 4321});
  movement.restart(std::vector<int>{17, 4321}, moved, turn);
  CHECK(movement.beyond(1e-10, moved, turn) == std::vector<int>{18});
}

TEST_CASE("the rigid part of a movement of few points, or of none, is a rigid motion") {
  for (const Points& start :
       {Points{{1, 2, 3}}, Points{{0, 0, 0}, {1, 0, 0}}, Points{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}}) {
    Movement movement;
    movement.start_from(start);
    const Eigen::Matrix3d turn = movement.rigid_part(start).linear();
    CHECK((turn * turn.transpose()).isIdentity(1e-12));
    CHECK(turn.determinant() == Approx(1));
    CHECK(movement.is_within(1e-12, start, movement.rigid_part(start)));
  }
}

TEST_CASE("what is brought to an end by the common motion has only its own way left to go") {
  std::mt19937 random(61);
  Points start(300), end;
  for (auto& p : start) p = random_point(random, 1);
  const Eigen::Isometry3d turn(Eigen::Translation3d(1, 2, -3) *
                               Eigen::AngleAxisd(1, Eigen::Vector3d::UnitY()));
  for (const auto& p : start) end.push_back(turn * (p + random_point(random, 1e-3)));
  const Points first = start;
  bring_to(end, start);
  for (std::size_t v = 0; v < start.size(); ++v) {
    CHECK((start[v] - end[v]).norm() < 3e-3);
    CHECK((start[v] - start[0]).norm() == Approx((first[v] - first[0]).norm()));
  }
}
