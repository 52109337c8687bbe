#include "tests/catch.h"
#include "tests/energies/textbook.h"

using namespace ringlet;
using namespace ringlet::test;

namespace {

const std::vector<int> strand_lengths{5, 2, 9, 3, 4, 7, 2, 2, 6, 11};
constexpr int all_vertices = 51;

}  // namespace

TEST_CASE("gradient and Hessian can be asked for one without the other") {
  std::mt19937_64 random(4);
  const Points rest = random_points(random, all_vertices), x = random_points(random, all_vertices);
  for (const std::string& name : elastic_names) {
    const Strands strands(strand_lengths, columns(rest), plain_material());
    const StrandGroups groups(strands);
    const auto energy = make_energy(name);
    energy->bind(strands, groups);
    const VertexField field = positions_with_pads(groups, columns(x));
    VertexField both(groups), alone(groups);
    StrandBands bands(groups), bands_alone(groups);
    for (int g = 0; g < groups.count(); ++g) {
      add_at_vertices(*energy, g, field.group(g), {both.group(g), bands.group(g)});
      add_at_vertices(*energy, g, field.group(g), {alone.group(g), {}});
      add_at_vertices(*energy, g, field.group(g), {{}, bands_alone.group(g)});
    }
    CHECK(both.matrix().isApprox(alone.matrix(), 1e-13));
    double largest = 0, difference = 0;
    for (int row = 0; row < groups.rows(); ++row) {
      for (int k = 0; k < band_blocks; ++k) {
        for (int m = 0; m < 9; ++m) {
          const Pack one = bands.block(row, k).m[m], other = bands_alone.block(row, k).m[m];
          largest = std::max<double>(largest, std::experimental::hmax(abs(one)));
          difference = std::max<double>(difference, std::experimental::hmax(abs(one - other)));
        }
      }
    }
    CHECK(difference < 1e-13 * largest);
  }
}

namespace {

/// An energy at x of strands that all look alike, and what it adds for the first of them.
struct OfFirst {
  double value = 0;
  Eigen::Matrix3Xd gradient;
  std::vector<double> hessian;  ///< its bands, row by row
};

OfFirst of_first(const std::string& name, int strands_alike, const Points& rest, const Points& x) {
  const int length = static_cast<int>(rest.cols());
  const Points rests = rest.replicate(1, strands_alike), positions = x.replicate(1, strands_alike);
  const Strands strands(std::vector<int>(strands_alike, length), columns(rests), plain_material());
  const StrandGroups groups(strands);
  const auto energy = make_energy(name);
  energy->bind(strands, groups);
  const VertexField field = positions_with_pads(groups, columns(positions));
  VertexField gradient(groups);
  StrandBands bands(groups);
  OfFirst result;
  for (int g = 0; g < groups.count(); ++g) {
    add_at_vertices(*energy, g, field.group(g), {gradient.group(g), bands.group(g)});
    result.value += energy->add(g, field.group(g), {});
  }
  result.gradient = gradient.matrix().leftCols(length);
  for (int vertex = 0; vertex < length; ++vertex) {
    const auto [row, lane] = groups.slot(vertex);
    for (int k = 0; k < band_blocks; ++k) {
      for (const Pack& entry : bands.block(row, k).m) result.hessian.push_back(entry[lane]);
    }
  }
  return result;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

}  // namespace

TEST_CASE("few strands, along which elements fill the lanes, are as strands of a full group") {
  std::mt19937_64 random(5);
  for (const int length : {2, 3, 4, 5, lane_count + 2, lane_count + 3, 3 * lane_count + 1}) {
    const Points rest = random_points(random, length), x = random_points(random, length);
    for (const std::string& name : elastic_names) {
      CAPTURE(name, length);
      const OfFirst full = of_first(name, lane_count, rest, x);
      for (const int few : {1, 2}) {
        const OfFirst alone = of_first(name, few, rest, x);
        CHECK(alone.value * lane_count == Approx(full.value * few).epsilon(1e-13));
        CHECK((alone.gradient - full.gradient).norm() <= 1e-13 * full.gradient.norm());
        const std::vector<double> none(full.hessian.size(), 0.0);
        CHECK(largest_difference(alone.hessian, full.hessian) <=
              1e-13 * largest_difference(full.hessian, none));
      }
    }
  }
}
