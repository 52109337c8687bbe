#include <Eigen/Cholesky>

#include "tests/catch.h"
#include "tests/solvers/random_system.h"

using namespace ringlet;

TEST_CASE("the product with a system matrix is that of the dense matrix") {
  const int contacts = GENERATE(0, 1, 40);
  const RandomSystem system({5, 9, 2, 14, 3, 4, 7, 8, 20, 6}, contacts, 1);
  const VertexField x = system.right_hand_side(2);
  VertexField y(system.groups);
  multiply(system.matrix, x, y);

  const Eigen::VectorXd expected = system.dense * x.matrix().reshaped();
  CHECK(expected.norm() > 1);
  CHECK(relative_difference(y.matrix(), expected.reshaped(3, expected.size() / 3)) < 1e-13);
  CHECK(system.matrix.couples_strands() == (contacts > 0));
}

TEST_CASE("blocks outside the bands are visited with both triangles, and the bands stay definite") {
  const RandomSystem system({5, 9, 2, 14, 3, 4, 7, 8, 20}, 30, 3);
  Eigen::MatrixXd sum = system.dense_bands;
  system.matrix.couplings.for_each_off_band(
      [&](int i, int j, const Eigen::Matrix3d& block) { sum.block<3, 3>(3 * i, 3 * j) += block; });
  CHECK((sum - system.dense).cwiseAbs().maxCoeff() < 1e-12);
  CHECK(system.dense_bands.llt().info() == Eigen::Success);
}

TEST_CASE("cleared couplings leave nothing behind") {
  RandomSystem system({5, 9, 4}, 30, 4);
  REQUIRE(system.matrix.couples_strands());
  system.matrix.couplings.clear();
  system.matrix.couplings.finish(system.free);
  CHECK_FALSE(system.matrix.couples_strands());
  CHECK(system.matrix.couplings.empty());
  VertexField x = system.right_hand_side(5), y(system.groups);
  system.matrix.couplings.add_product(0, x, y);
  CHECK(dot(y, y) == 0);
}
