#include "core/sources/merge_short_edges.h"
#include "tests/catch.h"

using namespace ringlet;

namespace {

// Strands along x with the given coordinates.
Polylines along_x(const std::vector<std::vector<double>>& strands) {
  Polylines polylines;
  for (const auto& strand : strands) {
    polylines.vertex_counts.push_back(static_cast<int>(strand.size()));
    for (const double x : strand) polylines.positions.emplace_back(x, 0, 0);
  }
  return polylines;
}

std::vector<double> coordinates(const Polylines& polylines) {
  std::vector<double> x;
  for (const auto& position : polylines.positions) x.push_back(position.x());
  return x;
}

}  // namespace

TEST_CASE("short edges are merged from the root on, and what becomes a point is dropped") {
  Polylines polylines =
      along_x({{0, 1, 1.05, 1.09, 1.2, 3, 3.05}, {5, 5.01, 5.02}, {7}, {}, {8, 9}});
  const MergeReport report = merge_short_edges(polylines, 0.1);
  CHECK(polylines.vertex_counts == std::vector<int>{4, 2});
  CHECK(coordinates(polylines) == std::vector<double>{0, 1, 1.2, 3, 8, 9});
  CHECK(report.merged_vertices == 3);
  CHECK(report.dropped_strands == 3);
}

TEST_CASE("a run of many tiny edges is shortened, not wiped out") {
  std::vector<double> fine;
  for (int i = 0; i <= 100; ++i) fine.push_back(0.01 * i);
  Polylines polylines = along_x({fine});
  merge_short_edges(polylines, 0.1);
  CHECK(polylines.vertex_counts[0] >= 9);
  CHECK(polylines.vertex_counts[0] <= 11);
}

TEST_CASE("a minimum of zero merges only what coincides") {
  Polylines polylines = along_x({{0, 0, 1e-12, 1}});
  const MergeReport report = merge_short_edges(polylines, 0);
  CHECK(coordinates(polylines) == std::vector<double>{0, 1e-12, 1});
  CHECK(report.merged_vertices == 1);
}

TEST_CASE("the median edge") {
  CHECK(median_edge(along_x({{0, 1, 3}, {10}, {20, 29}})) == 2);
  CHECK(median_edge(along_x({{1}, {}})) == 0);
}
