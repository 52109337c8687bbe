#include <tbb/global_control.h>

#include <Eigen/Geometry>
#include <functional>

#include "tests/catch.h"
#include "tests/collision/make_plugin.h"
#include "tests/collision/near_pairs.h"
#include "tests/collision/random_strands.h"

using namespace ringlet;

namespace {

using Random = std::mt19937;

double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

int integer(Random& random, int low, int high) {
  return std::uniform_int_distribution<int>(low, high)(random);
}

/// Strands somewhere in space, and what is near there.
struct Configuration {
  std::vector<int> sizes;
  Points x;
  double reach;

  void add_segment(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    sizes.push_back(2);
    x.insert(x.end(), {from, to});
  }
  /// The strands by themselves; where they stand makes no difference to a detector.
  Strands strands() const {
    Points anywhere;
    for (int v = 0; v < static_cast<int>(x.size()); ++v) anywhere.emplace_back(v, 0, 0);
    return Strands(sizes, anywhere, Material{});
  }
};

Configuration strands_of(Random& random, double reach,
                         const std::function<Eigen::Vector3d()>& next_vertex) {
  Configuration c{{}, {}, reach};
  const int count = integer(random, 1, 12);
  for (int strand = 0; strand < count; ++strand) {
    c.sizes.push_back(integer(random, 2, 24));
    for (int v = 0; v < c.sizes.back(); ++v) c.x.push_back(next_vertex());
  }
  return c;
}

Configuration wandering(Random& random) {
  const double step = uniform(random, 0.01, 0.3);
  Eigen::Vector3d p = random_point(random, 1);
  return strands_of(random, uniform(random, 0.01, 0.3), [&] {
    if (integer(random, 0, 20) == 0) p = random_point(random, 1);
    return p += random_point(random, step);
  });
}

// Distances are often exactly the reach, and segments parallel, collinear, identical, crossing,
// touching or of no length.
Configuration on_a_lattice(Random& random) {
  const int size = integer(random, 1, 4), flat = integer(random, 0, 1);
  return strands_of(random, integer(random, 1, 2), [=, &random] {
    return Eigen::Vector3d(integer(random, 0, size), integer(random, 0, size),
                           flat == 1 ? 0 : integer(random, 0, size));
  });
}

Configuration parallel(Random& random) {
  Configuration c{{}, {}, 0.1};
  const Eigen::Vector3d along = random_point(random, 1);
  const Eigen::Vector3d across = along.unitOrthogonal();
  for (int n = integer(random, 2, 20); n > 0; --n) {
    // Some exactly at the reach, some of them turned by less than rounding shows.
    const Eigen::Vector3d from =
        0.05 * integer(random, 0, 6) * across + uniform(random, -1, 1) * along;
    c.add_segment(from, from + along + uniform(random, 0, 1e-14) * across);
  }
  return c;
}

Configuration collinear(Random& random) {
  Configuration c{{}, {}, 0.125};
  const Eigen::Vector3d along = random_point(random, 1);
  for (int n = integer(random, 2, 20); n > 0; --n) {
    c.add_segment(0.125 * integer(random, -8, 8) * along, 0.125 * integer(random, -8, 8) * along);
  }
  return c;
}

Configuration touching(Random& random) {
  Configuration c{{}, {}, 1e-3};
  const Eigen::Vector3d hub = random_point(random, 1);
  for (int n = integer(random, 2, 10); n > 0; --n) {
    const Eigen::Vector3d end = random_point(random, 1);
    c.add_segment(hub, end);
    c.add_segment(0.5 * (hub + end), random_point(random, 1));  // a tip on a segment
  }
  return c;
}

Configuration points_and_copies(Random& random) {
  Configuration c{{}, {}, 0.2};
  for (int n = integer(random, 1, 6); n > 0; --n) {
    const Eigen::Vector3d p = random_point(random, 0.5), q = random_point(random, 0.5);
    for (int copies = integer(random, 1, 4); copies > 0; --copies) c.add_segment(p, q);
    c.add_segment(p, p);
    c.add_segment(q, p);
  }
  return c;
}

Configuration of_mixed_sizes(Random& random) {
  Configuration c{{}, {}, std::pow(10, uniform(random, -3, 0))};
  for (int n = integer(random, 10, 60); n > 0; --n) {
    const Eigen::Vector3d p = random_point(random, 1);
    c.add_segment(p, p + random_point(random, std::pow(10, uniform(random, -6, 1))));
  }
  return c;
}

Configuration far_away(Random& random) {
  Configuration c = wandering(random);
  const Eigen::Vector3d offset = random_point(random, std::pow(10, uniform(random, 2, 7)));
  for (auto& p : c.x) p += offset;
  return c;
}

Configuration of_another_scale(Random& random) {
  Configuration c = wandering(random);
  const double scale = std::pow(10, uniform(random, -9, 9));
  for (auto& p : c.x) p *= scale;
  c.reach *= scale;
  return c;
}

// One strand has flown away; the others must be found as before.
Configuration scattered(Random& random) {
  Configuration c = wandering(random);
  c.add_segment(random_point(random, 1e12), random_point(random, 1e-12));
  c.add_segment(random_point(random, 1e12), random_point(random, 1e12));
  return c;
}

std::unique_ptr<ContactDetector> make_detector(const char* name, const Strands& strands) {
  auto detector = make_plugin<ContactDetector>(name);
  detector->bind(strands);
  return detector;
}

}  // namespace

TEST_CASE("both detectors find the pairs of brute force, random and degenerate ones") {
  const unsigned seed = 5;
  CAPTURE(seed);
  Random random(seed);
  const std::vector<std::pair<const char*, Configuration (*)(Random&)>> kinds{
      {"wandering", wandering},
      {"on a lattice", on_a_lattice},
      {"parallel", parallel},
      {"collinear", collinear},
      {"touching", touching},
      {"points and copies", points_and_copies},
      {"of mixed sizes", of_mixed_sizes},
      {"far away", far_away},
      {"of another scale", of_another_scale},
      {"scattered", scattered}};
  for (const auto& [kind, make] : kinds) {
    CAPTURE(kind);
    std::size_t pairs = 0, near = 0;
    for (int n = 0; n < 100; ++n) {
      CAPTURE(n);
      const Configuration c = make(random);
      const Strands strands = c.strands();
      const auto expected = all_near_pairs(strands, c.x, c.reach);
      for (const char* name : {"fcl", "grid"}) {
        CAPTURE(name);
        std::vector<EdgePair> found;
        make_detector(name, strands)->find(c.x, c.reach, found);
        REQUIRE(found == expected);
      }
      near += expected.size();
      pairs += strands.edge_count() * (strands.edge_count() - 1) / 2;
    }
    CHECK(near > 100);
    CHECK(near < pairs);
  }
}

TEST_CASE("detectors follow strands wherever they go") {
  const auto name = GENERATE("fcl", "grid");
  const unsigned seed = 7;
  CAPTURE(name, seed);
  Random random(seed);
  const Strands strands = random_bundle(random, 200);
  const auto detector = make_detector(name, strands);
  Points x = rest_positions(strands);
  for (int move = 0; move < 6; ++move) {
    std::vector<EdgePair> found{{-1, -1}};
    detector->find(x, 1.5e-3, found);
    CHECK(found.size() > 300);
    CHECK(found == all_near_pairs(strands, x, 1.5e-3));
    for (auto& p : x) p = 0.9 * p + random_point(random, 0.003);
    if (move == 3) std::reverse(x.begin(), x.end());  // nothing stays where a tree was built
  }
}

TEST_CASE("of edges that moved alone, detectors find the pairs of brute force") {
  const auto name = GENERATE("fcl", "grid");
  const unsigned seed = 13;
  CAPTURE(name, seed);
  Random random(seed);
  const Strands strands = random_bundle(random, 200);
  const auto detector = make_detector(name, strands);
  Points x = rest_positions(strands);
  const double reach = 1.5e-3;
  std::vector<EdgePair> found;
  detector->find(x, reach, found);
  std::size_t near = 0;
  for (int move = 0; move < 20; ++move) {
    // Some to the other end of the bundle, some by little; neighbours among them.
    std::vector<int> edges;
    for (int n = integer(random, 0, 8); n > 0; --n) {
      const int v = integer(random, 0, strands.vertex_count() - 1), strand = strands.strand_of(v);
      x[v] = integer(random, 0, 1) == 0 ? random_point(random, 0.02)
                                        : Eigen::Vector3d(x[v] + random_point(random, 1e-3));
      if (v > strands.first(strand)) edges.push_back(v - 1);
      if (v + 1 < strands.first(strand) + strands.size(strand)) edges.push_back(v);
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    auto expected = all_near_pairs(strands, x, reach);
    std::erase_if(expected, [&](const EdgePair& pair) {
      return !std::binary_search(edges.begin(), edges.end(), pair.first) &&
             !std::binary_search(edges.begin(), edges.end(), pair.second);
    });
    detector->find_with(edges, x, reach, found);
    REQUIRE(found == expected);
    near += found.size();
  }
  CHECK(near > 100);
}

TEST_CASE("detectors survive what is not finite") {
  const auto name = GENERATE("fcl", "grid");
  CAPTURE(name);
  Random random(11);
  const Strands strands = random_bundle(random, 30);
  const auto detector = make_detector(name, strands);
  Points x = rest_positions(strands);
  x[3].x() = std::numeric_limits<double>::quiet_NaN();
  x[50].y() = std::numeric_limits<double>::infinity();
  x[90] = Eigen::Vector3d::Constant(-1e300);
  std::vector<EdgePair> found;
  detector->find(x, 1.5e-3, found);
  CHECK(found.size() > 10);
  for (const EdgePair& pair : found) CHECK(is_nearer(x, pair, 1.5e-3));
}

TEST_CASE("a single strand of one edge has no pairs") {
  const auto name = GENERATE("fcl", "grid");
  const Strands strands({2}, {{0, 0, 0}, {1, 0, 0}}, Material{});
  std::vector<EdgePair> found{{0, 1}};
  make_detector(name, strands)->find(rest_positions(strands), 1, found);
  CHECK(found.empty());
}
