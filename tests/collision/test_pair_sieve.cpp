#include <Eigen/Geometry>

#include "collision/detectors/pair_sieve.h"
#include "collision/segment_distance.h"
#include "tests/catch.h"
#include "tests/collision/random_strands.h"

using namespace ringlet;

namespace {

// What the sieve keeps of all pairs of segments 2i, 2i + 1 must be what is_nearer() says.
int check_all_pairs(const Points& x, double reach) {
  std::vector<EdgePair> expected, kept;
  PairSieve sieve(x, reach, kept);
  const int count = static_cast<int>(x.size());
  for (int a = 0; a < count; a += 2) {
    for (int b = a + 2; b < count; b += 2) {
      sieve.add({a, b});
      if (is_nearer(x, {a, b}, reach)) expected.push_back({a, b});
    }
  }
  sieve.flush();
  CHECK(kept == expected);
  return static_cast<int>(expected.size());
}

}  // namespace

TEST_CASE("the sieve keeps what is nearer than the reach, to the last bit") {
  std::mt19937 random(71);
  std::uniform_int_distribution<int> lattice(0, 3);
  int near = 0;
  for (int n = 0; n < 300; ++n) {
    const Eigen::Vector3d along = random_point(random, 1), across = along.unitOrthogonal();
    Points random_ones, on_a_lattice, nearly_parallel;
    for (int i = 0; i < 15; ++i) {
      random_ones.push_back(random_point(random, 1));
      random_ones.push_back(random_ones.back() + random_point(random, 0.3));
      for (int end = 0; end < 2; ++end) {
        on_a_lattice.emplace_back(lattice(random), lattice(random), lattice(random));
      }
      nearly_parallel.push_back(0.1 * i * across + random_point(random, 1).x() * along);
      nearly_parallel.push_back(nearly_parallel.back() + along +
                                std::pow(10, -lattice(random) * 5) * random_point(random, 1));
    }
    near += check_all_pairs(random_ones, 0.2);
    near += check_all_pairs(on_a_lattice, 1);
    near += check_all_pairs(nearly_parallel, 0.1);
  }
  CHECK(near > 1000);
}
