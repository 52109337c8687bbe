#include <Eigen/Geometry>
#include <sstream>

#include "collision/colliders/surface_normals.h"
#include "collision/colliders/triangle_distance.h"
#include "core/collider.h"
#include "tests/catch.h"
#include "tests/collision/make_plugin.h"
#include "tests/collision/random_strands.h"
#include "tests/temporary_file.h"

using namespace ringlet;

namespace {

using Face = std::array<int, 3>;

std::string to_obj(const Points& vertices, const std::vector<Face>& faces) {
  std::ostringstream text;
  text.precision(17);
  for (const auto& v : vertices) text << "v " << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
  for (const auto& f : faces) {
    text << "f " << f[0] + 1 << ' ' << f[1] + 1 << ' ' << f[2] + 1 << '\n';
  }
  return text.str();
}

struct Mesh {
  Points vertices;
  std::vector<Face> faces;
};

// The unit cube about the origin, each side n x n squares; sides share no vertices, so that they
// must be welded.
Mesh cube(int n) {
  Mesh mesh;
  for (int side = 0; side < 6; ++side) {
    const int axis = side / 2;
    const double sign = side % 2 == 0 ? 1 : -1;
    const int first = static_cast<int>(mesh.vertices.size());
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; j <= n; ++j) {
        Eigen::Vector3d p;
        p[axis] = 0.5 * sign;
        p[(axis + 1) % 3] = double(i) / n - 0.5;
        p[(axis + 2) % 3] = double(j) / n - 0.5;
        mesh.vertices.push_back(p);
      }
    }
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        const int a = first + i * (n + 1) + j, b = a + n + 1, c = b + 1, d = a + 1;
        const bool outward = sign > 0;
        mesh.faces.push_back(outward ? Face{a, b, c} : Face{a, c, b});
        mesh.faces.push_back(outward ? Face{a, c, d} : Face{a, d, c});
      }
    }
  }
  return mesh;
}

Mesh octahedron() {
  Mesh mesh;
  for (const double sign : {1.0, -1.0}) {
    for (int axis = 0; axis < 3; ++axis)
      mesh.vertices.push_back(sign * Eigen::Vector3d::Unit(axis));
  }
  for (int octant = 0; octant < 8; ++octant) {
    Face face{octant & 1 ? 3 : 0, octant & 2 ? 4 : 1, octant & 4 ? 5 : 2};
    const int flips = (octant & 1) + (octant >> 1 & 1) + (octant >> 2 & 1);
    if (flips % 2 == 1) std::swap(face[1], face[2]);
    mesh.faces.push_back(face);
  }
  return mesh;
}

// Four thin spikes about an axis: edges and vertices much sharper than a right angle.
Mesh spike() {
  Mesh mesh;
  mesh.vertices = {{0, 0, 1},     {0.05, 0, 0},  {0, 0.05, 0},
                   {-0.05, 0, 0}, {0, -0.05, 0}, {0, 0, 0.4}};
  for (int i = 0; i < 4; ++i) {
    const int a = 1 + i, b = 1 + (i + 1) % 4;
    mesh.faces.push_back({0, a, b});
    mesh.faces.push_back({5, b, a});  // hollow from below
  }
  return mesh;
}

std::unique_ptr<Collider> make_mesh(const Mesh& mesh, double depth) {
  const TemporaryFile file("obj", to_obj(mesh.vertices, mesh.faces));
  return make_plugin<Collider>(
      {{"type", "mesh"}, {"path", file.path().string()}, {"depth", depth}});
}

std::optional<Proximity> near(const Collider& collider, const Eigen::Vector3d& point,
                              double reach) {
  std::optional<Proximity> found;
  collider.near({&point, 1}, reach, {&found, 1});
  return found;
}

// The unsigned distance from all triangles by brute force.
double distance(const Mesh& mesh, const Eigen::Vector3d& p) {
  double least = 1e300;
  for (const Face& f : mesh.faces) {
    least = std::min(least,
                     closest_point(from_eigen(p), from_eigen(mesh.vertices[f[0]]),
                                   from_eigen(mesh.vertices[f[1]]), from_eigen(mesh.vertices[f[2]]))
                         .squared_distance);
  }
  return std::sqrt(least);
}

// Whether a closed mesh surrounds a point: its solid angle, by van Oosterom and Strackee's formula,
// is 4 pi inside and 0 outside.
bool is_inside(const Mesh& mesh, const Eigen::Vector3d& p) {
  double angle = 0;
  for (const Face& f : mesh.faces) {
    const Eigen::Vector3d a = mesh.vertices[f[0]] - p, b = mesh.vertices[f[1]] - p,
                          c = mesh.vertices[f[2]] - p;
    angle +=
        2 * std::atan2(a.dot(b.cross(c)), a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                                              a.dot(c) * b.norm() + b.dot(c) * a.norm());
  }
  return angle > 6;
}

void check_everywhere(const Mesh& mesh, double size, int count) {
  const unsigned seed = 43;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const auto collider = make_mesh(mesh, 10);
  int inside = 0;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d p = random_point(random, size);
    const auto found = near(*collider, p, 10);
    REQUIRE(found.has_value());
    const double sign = is_inside(mesh, p) ? -1 : 1;
    if (sign < 0) ++inside;
    CHECK(found->distance == Approx(sign * distance(mesh, p)).margin(1e-12));
    CHECK(found->normal.norm() == Approx(1));
    const Eigen::Vector3d foot = p - found->distance * found->normal;
    CHECK(distance(mesh, foot) == Approx(0).margin(1e-12));
  }
  CHECK((inside > 0 && inside < count));
}

}  // namespace

TEST_CASE("the closest point of a triangle is that of a search") {
  const unsigned seed = 47;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d p = random_point(random, 2), a = random_point(random, 1),
                          b = random_point(random, 1), c = random_point(random, 1);
    const auto found = closest_point(from_eigen(p), from_eigen(a), from_eigen(b), from_eigen(c));
    const auto [u, v, w] = found.weights;
    CHECK((u >= 0 && v >= 0 && w >= 0));
    CHECK(u + v + w == Approx(1));
    const double claimed = (u * a + v * b + w * c - p).squaredNorm();
    CHECK(found.squared_distance == Approx(claimed));
    double least = 1e300;
    constexpr int n = 100;
    for (int j = 0; j <= n; ++j) {
      for (int k = 0; j + k <= n; ++k) {
        const Eigen::Vector3d q = a + double(j) / n * (b - a) + double(k) / n * (c - a);
        least = std::min(least, (q - p).norm());
      }
    }
    CHECK(std::sqrt(claimed) <= least + 1e-12);
    CHECK(std::sqrt(claimed) >= least - 2.0 / n);
  }
}

TEST_CASE("mesh: distances are those of brute force, signs those of the solid angle") {
  SECTION("a cube, whose sides must be welded") { check_everywhere(cube(6), 1, 300); }
  SECTION("an octahedron") { check_everywhere(octahedron(), 1, 300); }
  SECTION("a hollow spike") { check_everywhere(spike(), 0.1, 2000); }
}

TEST_CASE("mesh: a cube is the box collider outside, and near its sides") {
  const auto mesh = make_mesh(cube(5), 0.1);
  const auto box = make_plugin<Collider>({{"type", "box"}, {"size", {1, 1, 1}}});
  std::mt19937 random(53);
  int found_count = 0, deep = 0;
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3d p = random_point(random, 0.7);
    const auto exact = near(*box, p, 0.05), found = near(*mesh, p, 0.05);
    const bool too_deep = exact.has_value() && exact->distance < -0.1;
    REQUIRE(found.has_value() == (exact.has_value() && !too_deep));
    if (too_deep) ++deep;
    if (!found) continue;
    ++found_count;
    CHECK(found->distance == Approx(exact->distance).margin(1e-12));
    CHECK((found->normal - exact->normal).norm() < 1e-9);
  }
  CHECK(found_count > 50);
  CHECK(deep > 50);
}

TEST_CASE("mesh: on the surface the normal is that of the face, edge or vertex") {
  const auto mesh = make_mesh(cube(1), 0.1);
  const auto face = near(*mesh, {0.5, 0.1, 0.2}, 0.1), corner = near(*mesh, {0.5, 0.5, 0.5}, 0.1);
  REQUIRE((face.has_value() && corner.has_value()));
  CHECK(face->distance == Approx(0).margin(1e-15));
  CHECK((face->normal - Eigen::Vector3d::UnitX()).norm() < 1e-12);
  CHECK((corner->normal - Eigen::Vector3d::Constant(1 / std::sqrt(3))).norm() < 1e-12);
}

TEST_CASE("mesh: several points are asked about together as one by one") {
  const auto mesh = make_mesh(cube(8), 0.2);
  std::mt19937 random(59);
  Points points;
  for (int i = 0; i < 9; ++i) points.push_back(random_point(random, 0.7));
  std::vector<std::optional<Proximity>> found(points.size());
  mesh->near(points, 0.2, found);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto alone = near(*mesh, points[i], 0.2);
    REQUIRE(alone.has_value() == found[i].has_value());
    if (alone) CHECK(alone->distance == found[i]->distance);
  }
}

TEST_CASE("mesh: triangles without area are left out, and a mesh of nothing else is refused") {
  Mesh with_needle = octahedron();
  with_needle.faces.push_back({0, 0, 1});
  with_needle.faces.push_back({2, 1, 1});
  check_everywhere(with_needle, 1, 50);

  Mesh flat{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}};
  CHECK_THROWS_AS(make_mesh(flat, 0.1), Error);
}
