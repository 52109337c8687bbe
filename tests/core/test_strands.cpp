#include "core/error.h"
#include "core/strand_groups.h"
#include "core/strands.h"
#include "core/vertex_field.h"
#include "tests/catch.h"

using namespace ringlet;

namespace {

const Material hair{.density = 1000, .radius = 2e-3, .tip_radius = 1e-3};

std::vector<Eigen::Vector3d> along_x(const std::vector<double>& xs) {
  std::vector<Eigen::Vector3d> positions;
  for (const double x : xs) positions.emplace_back(x, 0, 0);
  return positions;
}

Strands line_strands(const std::vector<int>& counts) {
  std::vector<Eigen::Vector3d> positions;
  for (std::size_t s = 0; s < counts.size(); ++s) {
    for (int i = 0; i < counts[s]; ++i) positions.emplace_back(0.01 * i, double(s), 0.0);
  }
  return Strands(counts, positions, hair);
}

}  // namespace

TEST_CASE("lengths, radii and masses follow from the rest shape and the material") {
  const Strands strands({3, 2}, along_x({0, 1, 4, 0, 2}), hair);
  CHECK(strands.edge_count() == 3);
  CHECK(strands.strand_of(3) == 1);
  CHECK(strands.rest_length(1) == 3);
  CHECK(strands.rest_length(2) == 0);
  CHECK(strands.strand_length(0) == 4);
  CHECK(strands.voronoi_length(0) == 0.5);
  CHECK(strands.voronoi_length(1) == 2);
  CHECK(strands.radius(0) == 2e-3);
  CHECK(strands.radius(1) == Approx(1.75e-3));
  CHECK(strands.radius(2) == Approx(1e-3));
  CHECK(strands.mass(1) == Approx(1000 * 3.14159265358979 * 1.75e-3 * 1.75e-3 * 2));
}

TEST_CASE("impossible strands are refused with the reason") {
  CHECK_THROWS_WITH(Strands({3, 1}, along_x({0, 1, 2, 3}), hair),
                    "strand 1 has 1 vertices; a strand needs at least 2");
  CHECK_THROWS_AS(Strands({3}, along_x({0, 1}), hair), Error);
  CHECK_THROWS_WITH(Strands({2, 2}, along_x({0, 1, 2, NAN}), hair),
                    "strand 1, vertex 1: position is not finite");
}

TEST_CASE("groups hold every vertex exactly once, longest strands first") {
  const std::vector<int> counts{5, 2, 9, 9, 3, 4, 7, 2, 2, 6, 11};
  const Strands strands = line_strands(counts);
  const StrandGroups groups(strands);
  const std::vector<int> longest_first{11, 9, 9, 7, 6, 5, 4, 3, 2, 2, 2};
  REQUIRE(groups.count() == (strands.count() + lane_count - 1) / lane_count);
  CHECK(groups[0].strands[0] == 10);
  int rows = 0;
  for (int g = 0; g < groups.count(); ++g) {
    CHECK(groups[g].first_row == rows);
    CHECK(groups[g].vertices == longest_first[g * lane_count]);
    rows += groups[g].vertices;
  }
  CHECK(groups.rows() == rows);
  std::vector<int> seen(strands.vertex_count());
  for (int row = 0; row < groups.rows(); ++row) {
    for (int lane = 0; lane < lane_count; ++lane) {
      const int vertex = groups.vertex_at(row, lane);
      if (vertex < 0) continue;
      ++seen[vertex];
      CHECK(groups.slot(vertex).row == row);
      CHECK(groups.slot(vertex).lane == lane);
    }
  }
  for (const int times : seen) CHECK(times == 1);
  for (int s = 0; s < strands.count(); ++s) {
    const LaneSlot root = groups.slot(strands.first(s));
    for (int i = 0; i < strands.size(s); ++i) {
      CHECK(groups.slot(strands.first(s) + i).row == root.row + i);
      CHECK(groups.slot(strands.first(s) + i).lane == root.lane);
    }
  }
}

TEST_CASE("strands of one length that stand near each other share a group") {
  // As many on every corner of a cube as a group holds, the corners in turn.
  std::vector<Eigen::Vector3d> positions;
  for (int n = 0; n < 8 * lane_count; ++n) {
    const Eigen::Vector3d corner(n % 2, n / 2 % 2, n / 4 % 2);
    const Eigen::Vector3d root = corner + 1e-3 * Eigen::Vector3d(n, n % 3, -n) / lane_count;
    positions.push_back(root);
    positions.push_back(root + Eigen::Vector3d(0, 0.1, 0));
  }
  const StrandGroups groups(Strands(std::vector<int>(8 * lane_count, 2), positions, hair));
  REQUIRE(groups.count() == 8);
  for (int g = 0; g < 8; ++g) {
    for (const int strand : groups[g].strands) CHECK(strand % 8 == groups[g].strands[0] % 8);
  }
}

TEST_CASE("strands whose roots are all in one place have groups, too") {
  const StrandGroups groups(Strands({2, 2}, {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 1, 0}}, hair));
  CHECK(groups.rows() == (lane_count < 2 ? 4 : 2));
}

TEST_CASE("a field gives back what was set, and its dot product ignores pads of zero fields") {
  const Strands strands = line_strands({5, 2, 9});
  const StrandGroups groups(strands);
  VertexField a(groups), b(groups);
  const Eigen::Matrix3Xd values = Eigen::Matrix3Xd::Random(3, strands.vertex_count());
  a.set_matrix(values);
  b.set_matrix(2 * values);
  CHECK(a.matrix() == values);
  CHECK(dot(a, b) == Approx(2 * values.squaredNorm()));
  add_scaled(b, -2, a);
  CHECK(b.matrix().norm() == 0);
}

TEST_CASE("pads stand on a helix without a degenerate stencil") {
  for (int i = 0; i < 50; ++i) {
    const auto edge = pad_position(i + 1) - pad_position(i);
    const auto next = pad_position(i + 2) - pad_position(i + 1);
    CHECK(norm(edge) > 0.5);
    CHECK(norm(cross(edge, next)) > 0.5);
  }
}
