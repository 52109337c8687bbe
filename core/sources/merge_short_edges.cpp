#include "core/sources/merge_short_edges.h"

#include <algorithm>

namespace ringlet {

double median_edge(const Polylines& polylines) {
  std::vector<double> lengths;
  std::size_t first = 0;
  for (const int vertices : polylines.vertex_counts) {
    for (std::size_t v = first; v + 1 < first + vertices; ++v) {
      lengths.push_back((polylines.positions[v + 1] - polylines.positions[v]).norm());
    }
    first += vertices;
  }
  if (lengths.empty()) return 0;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

MergeReport merge_short_edges(Polylines& polylines, double minimum_edge) {
  MergeReport report{minimum_edge};
  Polylines kept;
  std::size_t first = 0;
  for (const int vertices : polylines.vertex_counts) {
    const std::size_t begin = kept.positions.size();
    for (std::size_t v = first; v < first + vertices; ++v) {
      const Eigen::Vector3d& x = polylines.positions[v];
      if (v == first || (x - kept.positions.back()).norm() > minimum_edge) {
        kept.positions.push_back(x);
      }
    }
    first += vertices;
    const int left = static_cast<int>(kept.positions.size() - begin);
    if (left < 2) {
      kept.positions.resize(begin);
      ++report.dropped_strands;
    } else {
      kept.vertex_counts.push_back(left);
      report.merged_vertices += vertices - left;
    }
  }
  polylines = std::move(kept);
  return report;
}

}  // namespace ringlet
