#include "tests/catch.h"
#include "tests/energies/textbook.h"

using namespace ringlet;
using namespace ringlet::test;

namespace {

const std::vector<int> counts{5, 2, 9, 3, 4, 7, 2, 2, 6, 11};
constexpr int vertices = 51;

}  // namespace

TEST_CASE("gradient and Hessian can be asked for one without the other") {
  std::mt19937_64 random(4);
  const Points rest = random_points(random, vertices), x = random_points(random, vertices);
  for (const std::string& name : elastic_names) {
    const Strands strands(counts, columns(rest), plain_material());
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
