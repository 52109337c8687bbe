#include <random>

#include "core/edge_derivatives.h"
#include "tests/catch.h"

using namespace ringlet;

namespace {

constexpr int vertices = 7;
constexpr int edges = vertices - 1;

/// Derivatives over edges, filled at random, and the same dense in one lane.
struct RandomDerivatives {
  EdgeDerivatives sparse;
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(3 * edges);
  Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(3 * edges, 3 * edges);
  static constexpr int lane = lane_count - 1;

  explicit RandomDerivatives(unsigned seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    sparse.begin(vertices);
    const EdgeOutputs outputs = sparse.outputs();
    for (int i = 0; i < edges; ++i) {
      for (int c = 0; c < 3; ++c) gradient(3 * i + c) = normal(random);
      outputs.gradient[i].x[lane] = gradient(3 * i);
      outputs.gradient[i].y[lane] = gradient(3 * i + 1);
      outputs.gradient[i].z[lane] = gradient(3 * i + 2);
      for (int k = 0; k <= std::min(i, edge_band_blocks - 1); ++k) {
        for (int r = 0; r < 3; ++r) {
          for (int c = 0; c < 3; ++c) {
            const double entry = normal(random);
            // Above the diagonal nothing has a meaning.
            outputs.hessian.block(i, k)(r, c)[lane] = entry;
            const int row = 3 * i + r, column = 3 * (i - k) + c;
            if (column <= row) hessian(row, column) = hessian(column, row) = entry;
          }
        }
      }
    }
  }
};

Eigen::MatrixXd differences() {
  Eigen::MatrixXd d = Eigen::MatrixXd::Zero(3 * edges, 3 * vertices);
  for (int i = 0; i < 3 * edges; ++i) {
    d(i, i) = -1;
    d(i, i + 3) = 1;
  }
  return d;
}

}  // namespace

TEST_CASE("derivatives over edges become those over vertices") {
  RandomDerivatives given(1);
  const Eigen::VectorXd gradient = differences().transpose() * given.gradient;
  const Eigen::MatrixXd hessian = differences().transpose() * given.hessian * differences();

  std::vector<Vector3<Pack>> rows(vertices, {0, 0, 0});
  std::vector<Matrix3<Pack>> blocks(vertices * band_blocks, Matrix3<Pack>::zero());
  const GroupBands bands{std::span(blocks)};
  given.sparse.add_to({rows, bands});
  constexpr int lane = RandomDerivatives::lane;
  for (int i = 0; i < vertices; ++i) {
    CHECK(rows[i].x[lane] == Approx(gradient(3 * i)));
    CHECK(rows[i].y[lane] == Approx(gradient(3 * i + 1)));
    CHECK(rows[i].z[lane] == Approx(gradient(3 * i + 2)));
    for (int k = 0; k <= std::min(i, band_blocks - 1); ++k) {
      for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) {
          INFO(i << ", " << k << ": " << r << ", " << c);
          CHECK(bands.block(i, k)(r, c)[lane] == Approx(hessian(3 * i + r, 3 * (i - k) + c)));
        }
      }
    }
  }
}

TEST_CASE("edge derivatives start at zero again, for fewer or more vertices, too") {
  const int next = GENERATE(vertices - 2, vertices, vertices + 3);
  const int taken = GENERATE(0, 1, vertices - 1, vertices);
  RandomDerivatives given(2);
  Matrix3<Pack> row[band_blocks];
  for (int i = 0; i < taken; ++i) given.sparse.take_row(i, row);
  for (const int again : {next, vertices + 3}) {
    given.sparse.begin(again);
    const EdgeOutputs outputs = given.sparse.outputs();
    REQUIRE(static_cast<int>(outputs.gradient.size()) == again);
    for (int i = 0; i < again; ++i) {
      CHECK(std::experimental::all_of(outputs.gradient[i].x == 0));
      for (int k = 0; k < edge_band_blocks; ++k) {
        for (const Pack& entry : outputs.hessian.block(i, k).m) {
          CHECK(std::experimental::all_of(entry == 0));
        }
      }
    }
  }
}
