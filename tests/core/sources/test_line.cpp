#include "core/strand_source.h"
#include "tests/catch.h"
#include "tests/core/read_plugin.h"

using namespace ringlet;

TEST_CASE("a line is straight, evenly divided, and as long as asked") {
  const StrandSet set =
      make_plugin<StrandSource>({{"type", "line"},
                                 {"vertices", 5},
                                 {"length", 0.2},
                                 {"roots", {{"type", "point"}, {"direction", {3, 0, 0}}}}})
          ->generate();
  REQUIRE(set.vertex_counts == std::vector<int>{5});
  for (int v = 0; v < 5; ++v) {
    CHECK((set.positions[v] - Eigen::Vector3d(0.05 * v, 0, 0)).norm() < 1e-15);
  }
  CHECK(set.pinned_counts == std::vector<int>{2});
}

TEST_CASE("a line of no length is refused") {
  const auto read = read_plugin<StrandSource>({{"type", "line"}, {"length", 0}});
  CHECK(read.has_one_problem("/length", "expected number > 0 in m, found 0"));
}
