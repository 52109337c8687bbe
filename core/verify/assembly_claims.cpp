#include <numeric>

#include "core/verify/subject.h"

namespace ringlet {

namespace {

constexpr double allowed_difference = 1e-11;

/// Strands of many lengths: full groups, pads, and strands without an element.
std::vector<int> strand_sizes(int vertices) {
  return {vertices, vertices + 1, 2,           vertices + 5, vertices, vertices + 2, 2,
          3,        vertices + 7, vertices + 3};
}

double difference(const Probe& a, const Probe& b) {
  const double value = std::abs(a.value - b.value) / std::max(std::abs(b.value), 1e-300);
  return std::max({value, relative_difference(a.gradient, b.gradient, 1e-300),
                   relative_difference(a.hessian, b.hessian, 1e-300)});
}

struct DeformedStrands {
  std::vector<int> sizes;
  Points rest, x;
};

Probe sum_one_by_one(const Subject& subject, const std::string& filter,
                     const DeformedStrands& strands) {
  const auto entries = strands.x.size();
  Probe sum{0, Eigen::VectorXd::Zero(entries), Eigen::MatrixXd::Zero(entries, entries), 0};
  int first = 0;
  for (const int size : strands.sizes) {
    const BoundEnergy alone(subject.energy(filter), strands.rest.middleCols(first, size));
    const Probe probe = alone.at(strands.x.middleCols(first, size));
    sum.value += probe.value;
    sum.gradient.segment(3 * first, 3 * size) += probe.gradient;
    sum.hessian.block(3 * first, 3 * first, 3 * size, 3 * size) += probe.hessian;
    first += size;
  }
  return sum;
}

/// The largest entry that pads received.
double written_on_pads(const BoundEnergy& bound, const Points& x) {
  const StrandGroups& groups = bound.groups();
  const VertexField field = positions_with_pads(groups, columns(x));
  VertexField gradient(groups);
  StrandBands bands(groups);
  for (int g = 0; g < groups.count(); ++g) {
    add_at_vertices(bound.energy(), g, field.group(g), {gradient.group(g), bands.group(g)});
  }
  double largest = 0;
  const auto see = [&](double entry) { largest = std::max(largest, std::abs(entry)); };
  for (int row = 0; row < groups.rows(); ++row) {
    for (int lane = 0; lane < lane_count; ++lane) {
      if (groups.vertex_at(row, lane) >= 0) continue;
      const Vector3<Pack>& slope = gradient.rows()[row];
      for (const Pack& entry : {slope.x, slope.y, slope.z}) see(entry[lane]);
      for (int k = 0; k < band_blocks; ++k) {
        for (const Pack& entry : bands.block(row, k).m) see(entry[lane]);
      }
    }
  }
  return largest;
}

}  // namespace

void claim_assembly(const Subject& subject, std::vector<Claim>& claims) {
  Claim apart{"strands do not see each other", allowed_difference};
  Claim pads{"pads stay untouched", 0};
  Claim scalar{"lanes compute what plain doubles do", allowed_difference};
  const bool has_scalar = subject.energy("", {{"evaluation", "scalar"}}) != nullptr;
  std::mt19937_64 random(subject.seed);
  for (const std::string& filter : subject.variants()) {
    DeformedStrands strands{strand_sizes(subject.vertices), {}, {}};
    const int count = std::accumulate(strands.sizes.begin(), strands.sizes.end(), 0);
    strands.rest = random_points(random, count);
    strands.x = random_points(random, count);
    const BoundEnergy lanes(subject.energy(filter), strands.sizes, strands.rest);
    const Probe together = lanes.at(strands.x);
    const std::string name = filter.empty() ? "10 random strands" : "10 random strands, " + filter;
    apart.see(difference(together, sum_one_by_one(subject, filter, strands)), name);
    pads.see(written_on_pads(lanes, strands.x), name);
    if (!has_scalar) continue;
    const BoundEnergy one_by_one(subject.energy(filter, {{"evaluation", "scalar"}}), strands.sizes,
                                 strands.rest);
    scalar.see(difference(together, one_by_one.at(strands.x)), name);
  }
  claims.push_back(std::move(apart));
  claims.push_back(std::move(pads));
  if (has_scalar) claims.push_back(std::move(scalar));
}

}  // namespace ringlet
