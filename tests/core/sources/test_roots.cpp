#include <cmath>

#include "core/strand_source.h"
#include "tests/catch.h"
#include "tests/core/read_plugin.h"

using namespace ringlet;

TEST_CASE("roots on a sphere lie on it and grow outwards") {
  const auto roots =
      make_plugin<RootSource>({{"type", "sphere"}, {"radius", 0.15}, {"centre", {1, 2, 3}}})
          ->place(50, 1);
  REQUIRE(roots.size() == 50);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Root& root : roots) {
    const Eigen::Vector3d out = root.position - Eigen::Vector3d(1, 2, 3);
    CHECK(out.norm() == Approx(0.15));
    CHECK(root.direction.dot(out) == Approx(0.15));
    mean += root.direction / 50;
  }
  CHECK(mean.norm() < 0.1);  // they stand all around
}

TEST_CASE("roots on a hemisphere lie on the half that is up") {
  for (const Eigen::Vector3d& up :
       {Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, -3, 0), Eigen::Vector3d(1, 0, 1)}) {
    const auto roots =
        make_plugin<RootSource>(
            {{"type", "hemisphere"}, {"radius", 0.15}, {"up", {up.x(), up.y(), up.z()}}})
            ->place(50, 1);
    double lowest = 1;
    for (const Root& root : roots) {
      CHECK(root.direction.norm() == Approx(1));
      lowest = std::min(lowest, root.direction.dot(up.normalized()));
    }
    CHECK(lowest > -1e-12);
    CHECK(lowest < 0.2);
  }
}

TEST_CASE("roots in a row stand side by side") {
  const auto roots = make_plugin<RootSource>({{"type", "row"},
                                              {"position", {0, 0, 1}},
                                              {"spacing", {0, 0, 0.5}},
                                              {"direction", {2, 0, 0}}})
                         ->place(3, 1);
  REQUIRE(roots.size() == 3);
  CHECK(roots[2].position == Eigen::Vector3d(0, 0, 2));
  CHECK(roots[2].direction == Eigen::Vector3d(1, 0, 0));
}

TEST_CASE("the point root is the origin, upwards, unless told otherwise") {
  const auto roots = make_plugin<RootSource>("point")->place(1, 1);
  REQUIRE(roots.size() == 1);
  CHECK(roots[0].position == Eigen::Vector3d(0, 0, 0));
  CHECK(roots[0].direction == Eigen::Vector3d(0, 1, 0));
}

TEST_CASE("bad parameters of roots are reported") {
  CHECK(read_plugin<RootSource>("sphere").has_one_problem("/radius", "missing"));
  CHECK(read_plugin<RootSource>({{"type", "sphere"}, {"radius", -1}})
            .has_one_problem("/radius", "> 0 in m"));
  CHECK(read_plugin<RootSource>({{"type", "point"}, {"direction", {0, 0, 0}}})
            .has_one_problem("/direction", "other than zero"));
  CHECK(read_plugin<RootSource>({{"type", "point"}, {"position", {0, 0}}})
            .has_one_problem("/position", "3 numbers"));
}
