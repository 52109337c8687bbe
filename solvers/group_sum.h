#pragma once

#include <numeric>
#include <vector>

#include "core/parallel.h"
#include "core/vertex_field.h"

namespace ringlet {

/// Sums over the groups of strands: computed in parallel, added in order, so that their bits do not
/// depend on the number of threads. Keeps its memory between calls.
class GroupSum {
 public:
  GroupSum() = default;
  explicit GroupSum(const StrandGroups& groups) : terms_(groups.count()) {}

  /// The sum of body(group).
  template <class Body>
  double operator()(const Body& body) {
    parallel_for_each(static_cast<int>(terms_.size()), [&](int g) { terms_[g] = body(g); });
    return std::accumulate(terms_.begin(), terms_.end(), 0.0);
  }

  double dot(const VertexField& a, const VertexField& b) {
    return (*this)([&](int g) {
      const auto rows_a = a.group(g), rows_b = b.group(g);
      Pack sum = 0;
      for (std::size_t i = 0; i < rows_a.size(); ++i) sum += ringlet::dot(rows_a[i], rows_b[i]);
      return sum_lanes(sum);
    });
  }

 private:
  std::vector<double> terms_;
};

}  // namespace ringlet
