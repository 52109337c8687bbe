#include <sstream>

#include "collision/colliders/distance_grid_file.h"
#include "core/collider.h"
#include "tests/catch.h"
#include "tests/collision/make_plugin.h"
#include "tests/collision/random_strands.h"
#include "tests/temporary_file.h"

using namespace ringlet;

namespace {

constexpr double resolution = 0.02;

/// A ball of radius 0.5 of flat triangles, or with n = 1 an octahedron.
std::string ball(int n) {
  std::ostringstream text;
  text.precision(17);
  int vertices = 0;
  for (int octant = 0; octant < 8; ++octant) {
    const Eigen::Vector3d signs(octant & 1 ? -1 : 1, octant & 2 ? -1 : 1, octant & 4 ? -1 : 1);
    const bool mirrored = signs.prod() < 0;
    const auto vertex = [&](int i, int j) {
      const Eigen::Vector3d p =
          0.5 * Eigen::Vector3d(i, j, n - i - j).normalized().cwiseProduct(signs);
      text << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
      return ++vertices;
    };
    const auto face = [&](int a, int b, int c) {
      text << "f " << a << ' ' << (mirrored ? c : b) << ' ' << (mirrored ? b : c) << '\n';
    };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; i + j < n; ++j) {
        face(vertex(i, j), vertex(i + 1, j), vertex(i, j + 1));
        if (i + j + 1 < n) face(vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
      }
    }
  }
  return text.str();
}

Json description(const char* type, const TemporaryFile& mesh) {
  return {{"type", type}, {"path", mesh.path().string()}, {"depth", 0.1}};
}

std::unique_ptr<Collider> make_sdf(const TemporaryFile& mesh, bool cache = false) {
  Json json = description("sdf", mesh);
  json["resolution"] = resolution;
  json["cache"] = cache;
  return make_plugin<Collider>(json);
}

std::vector<std::optional<Proximity>> all_near(const Collider& collider, const Points& points,
                                               double reach) {
  std::vector<std::optional<Proximity>> found(points.size());
  collider.near(points, reach, found);
  return found;
}

Points random_points(int count) {
  std::mt19937 random(73);
  Points points;
  for (int n = 0; n < count; ++n) points.push_back(random_point(random, 0.7));
  return points;
}

/// The largest error of a distance, and the largest angle between normals, rad.
std::pair<double, double> errors(const std::string& obj, double reach) {
  const TemporaryFile mesh("obj", obj);
  const auto exact = make_plugin<Collider>(description("mesh", mesh));
  const Points points = random_points(3000);
  const auto expected = all_near(*exact, points, reach),
             found = all_near(*make_sdf(mesh), points, reach);
  double distance = 0, angle = 0;
  int count = 0;
  for (std::size_t n = 0; n < points.size(); ++n) {
    // Within the error of the limits one may find what the other does not.
    if (!expected[n].has_value() || !found[n].has_value()) continue;
    ++count;
    CHECK(found[n]->normal.norm() == Approx(1));
    distance = std::max(distance, std::abs(found[n]->distance - expected[n]->distance));
    angle = std::max(angle, std::acos(std::min(1.0, found[n]->normal.dot(expected[n]->normal))));
  }
  CHECK(count > 200);
  return {distance, angle};
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ostringstream bytes;
  bytes << std::ifstream(file, std::ios::binary).rdbuf();
  return bytes.str();
}

/// Its file beside a mesh, removed at the end.
struct CacheFile {
  std::filesystem::path path;
  explicit CacheFile(const TemporaryFile& mesh) : path(mesh.path().string() + ".sdf") {}
  ~CacheFile() { std::filesystem::remove(path); }
};

}  // namespace

TEST_CASE("sdf: the error of a grid is below its bounds") {
  const double reach = GENERATE(0.05, 0.1);
  // Curvatures of 2 to 2.5 /m, and facets of a size at which they make 1e-4 m of their own.
  CHECK(errors(ball(40), reach).first < (2.5 + 2.5) * resolution * resolution / 8 + 1e-4);
  CHECK(errors(ball(40), reach).second < 0.05);
  CHECK(errors(ball(1), reach).first < std::sqrt(0.75) * resolution);
}

TEST_CASE("sdf: what is near the mesh is found, what is not is not") {
  const TemporaryFile mesh("obj", ball(1));
  const auto exact = make_plugin<Collider>(description("mesh", mesh)), sdf = make_sdf(mesh);
  const Points points = random_points(3000);
  constexpr double reach = 0.06, error = 0.0175;
  const auto found = all_near(*sdf, points, reach);
  const auto all = all_near(*exact, points, 1);
  int inside = 0, outside = 0;
  for (std::size_t n = 0; n < points.size(); ++n) {
    const bool is_known = all[n].has_value();  // less than 0.1 deep inside
    if (is_known && all[n]->distance < reach - error && all[n]->distance > -0.1 + error) {
      CHECK(found[n].has_value());
      ++inside;
    }
    if (!is_known || all[n]->distance > reach + error) ++outside;
    if (is_known && all[n]->distance > reach + error) CHECK_FALSE(found[n].has_value());
  }
  CHECK((inside > 100 && outside > 100));
}

TEST_CASE("sdf: further away than the grid reaches the mesh is asked") {
  const TemporaryFile mesh("obj", ball(3));
  const auto exact = make_plugin<Collider>(description("mesh", mesh)), sdf = make_sdf(mesh);
  const Points points = random_points(300);
  const auto expected = all_near(*exact, points, 0.3), found = all_near(*sdf, points, 0.3);
  for (std::size_t n = 0; n < points.size(); ++n) {
    REQUIRE(found[n].has_value() == expected[n].has_value());
    if (expected[n]) CHECK(found[n]->distance == expected[n]->distance);
  }
}

TEST_CASE("sdf: a point that is not finite is near nothing") {
  const TemporaryFile mesh("obj", ball(1));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto found = all_near(*make_sdf(mesh), {{nan, 0, 0}, {0, 1e300, 0}}, 0.05);
  CHECK_FALSE(found[0].has_value());
  CHECK_FALSE(found[1].has_value());
}

TEST_CASE("sdf: a grid on disk is used, and made anew if damaged or outdated") {
  const TemporaryFile mesh("obj", ball(3));
  const CacheFile cache(mesh);
  make_sdf(mesh);
  CHECK_FALSE(std::filesystem::exists(cache.path));  // nothing is written unless asked for
  const Points points = random_points(300);
  const auto fresh = all_near(*make_sdf(mesh, true), points, 0.1);
  REQUIRE(std::filesystem::exists(cache.path));
  const std::string intact = bytes_of(cache.path);
  const auto check_same = [&] {
    const auto found = all_near(*make_sdf(mesh, true), points, 0.1);
    for (std::size_t n = 0; n < points.size(); ++n) {
      REQUIRE(found[n].has_value() == fresh[n].has_value());
      if (fresh[n]) CHECK(found[n]->distance == fresh[n]->distance);
    }
    CHECK(bytes_of(cache.path) == intact);
  };
  check_same();
  for (std::string damaged :
       {intact, intact, intact.substr(0, 1000), std::string(), intact + "x"}) {
    if (damaged == intact) damaged[damaged.size() / 2] ^= 4;
    std::ofstream(cache.path, std::ios::binary) << damaged;
    check_same();
  }
  std::ofstream(mesh.path()) << ball(4);
  make_sdf(mesh, true);
  CHECK(bytes_of(cache.path) != intact);
}

TEST_CASE("sdf: a file of another origin is not read") {
  const TemporaryFile mesh("obj", ball(2)), file("sdf", "");
  const MeshDistance exact(read_obj_mesh(mesh.path()), mesh.path());
  const DistanceGrid grid = make_distance_grid(exact, 0.05, 0.1);
  const GridOrigin origin{5, 0.05, 0.1};
  write_distance_grid(grid, origin, file.path());
  const auto read = read_distance_grid(file.path(), origin);
  REQUIRE(read.has_value());
  CHECK(read->distances == grid.distances);
  CHECK(read->block_at == grid.block_at);
  CHECK_FALSE(read_distance_grid(file.path(), {6, 0.05, 0.1}).has_value());
  CHECK_FALSE(read_distance_grid(file.path(), {5, 0.04, 0.1}).has_value());
  CHECK_FALSE(read_distance_grid(file.path(), {5, 0.05, 0.2}).has_value());
  CHECK_FALSE(read_distance_grid(file.path().string() + "_none", origin).has_value());
}

TEST_CASE("sdf: a resolution that no memory holds is refused") {
  const TemporaryFile mesh("obj", ball(1));
  Json json = description("sdf", mesh);
  json["resolution"] = 1e-6;
  CHECK_THROWS_WITH(make_plugin<Collider>(json), contains("make it at least"));
}
