#include "solvers/kept_factors.h"
#include "tests/catch.h"
#include "tests/solvers/random_system.h"

using namespace ringlet;

namespace {

double largest_difference(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

/// The factors of a system's bands, kept for a tolerance, and solutions with them.
struct Kept {
  Kept(const RandomSystem& system, double tolerance) : matrix(system.matrix) {
    factors.bind(system.groups, tolerance);
    b = system.right_hand_side(7);
    x = b;
    for (int g = 0; g < system.groups.count(); ++g) {
      const GroupBands bands = matrix.bands.group(g);
      REQUIRE(factor_rows(bands, {0, bands.rows()}, x.group(g)));
      substitute_back(bands, x.group(g));
      factors.keep(g, bands, b.group(g), x.group(g));
    }
  }
  Eigen::Matrix3Xd solve(const RandomSystem& system) const {
    VertexField found = system.right_hand_side(8);
    for (int g = 0; g < system.groups.count(); ++g) factors.solve(g, 0, found.group(g));
    return found.matrix();
  }
  /// Relative to the largest entry.
  double error(const RandomSystem& system) const {
    return largest_difference(
        solve(system), RandomSystem::dense_solution(system.dense_bands, system.right_hand_side(8)));
  }

  SystemMatrix matrix;
  VertexField b, x;
  KeptFactors factors;
};

/// Joints that resist bending far more than anything holds their strand in place.
void stiffen(RandomSystem& system, double stiffness) {
  const std::array<double, 3> differences{1, -2, 1};
  for (int s = 0; s < system.strands.count(); ++s) {
    for (int v = system.strands.first(s) + 4; v < system.strands.first(s + 1); ++v) {
      const auto [row, lane] = system.groups.slot(v);
      const int group = system.groups.group_of(v), i = row - system.groups[group].first_row;
      const double joint = stiffness * (1.5 + std::sin(3.0 * v));
      for (int a = 0; a < 3; ++a) {
        for (int k = 0; k + a < 3; ++k) {
          Matrix3<Pack>& block = system.matrix.bands.group(group).block(i - a, k);
          for (int c = 0; c < 3; ++c) {
            block(c, c)[lane] += joint * differences[a] * differences[a + k];
          }
        }
      }
    }
  }
}

}  // namespace

TEST_CASE("without a tolerance factors are kept as they are") {
  const RandomSystem system(mixed_lengths, 10, 1);
  CHECK(Kept(system, 0).error(system) < 1e-12);
}

TEST_CASE("for a tolerance they are rounded to single precision, in half the memory") {
  const RandomSystem system(mixed_lengths, 10, 2);
  const Kept rounded(system, 1e-2), exact(system, 0);
  CHECK(rounded.error(system) < 1e-5);
  CHECK(rounded.error(system) > 1e-12);
  CHECK(rounded.factors.bytes() < 0.75 * static_cast<double>(exact.factors.bytes()));
}

TEST_CASE("a factor that rounding would change too much is kept as it is") {
  RandomSystem system({300, 200, 5}, 0, 3);
  stiffen(system, 1e10);
  const Eigen::Matrix3Xd exact = Kept(system, 0).solve(system);
  const double by_rounding = largest_difference(Kept(system, 1e-2).solve(system), exact);
  CHECK(by_rounding > 1e-6);
  CHECK(by_rounding < 1e-4);
  CHECK(largest_difference(Kept(system, 2e-6).solve(system), exact) == 0);
}

TEST_CASE("factors that single precision cannot hold are kept as they are") {
  RandomSystem system(mixed_lengths, 0, 4);
  const std::array<double, 3> scales{1e-45, 1, 1};  // of x, y and z
  for (int g = 0; g < system.groups.count(); ++g) {
    for (Matrix3<Pack>& block : system.matrix.bands.group(g).blocks()) {
      for (int n = 0; n < 9; ++n) block.m[n] *= scales[n / 3] * scales[n % 3];
    }
  }
  for (int c = 0; c < system.dense_bands.cols(); ++c) {
    for (int r = 0; r < system.dense_bands.rows(); ++r) {
      system.dense_bands(r, c) *= scales[r % 3] * scales[c % 3];
    }
  }
  CHECK(Kept(system, 1e-2).error(system) < 1e-12);
}

TEST_CASE("solutions may begin behind the first rows") {
  const RandomSystem system({9, 9, 9}, 6, 5);
  for (const double tolerance : {0.0, 1e-2}) {
    const Kept kept(system, tolerance);
    VertexField whole(system.groups), part(system.groups);
    for (int row = 4; row < 9; ++row) whole.rows()[row] = part.rows()[row] = {Pack(1), 2, -1};
    kept.factors.solve(0, 0, whole.group(0));
    kept.factors.solve(0, 4, part.group(0));
    for (int row = 4; row < 9; ++row) {
      CHECK(squared_norm(whole.rows()[row] - part.rows()[row])[0] == 0);
    }
  }
}
