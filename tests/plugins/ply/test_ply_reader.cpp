#include "tests/plugins/written_run.h"

using namespace ringlet;

namespace {

std::string ply(const std::string& elements, const std::string& rows) {
  return "ply\nformat ascii 1.0\n" + elements + "end_header\n" + rows;
}

const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string ends = "property int vertex1\nproperty int vertex2\n";

std::string points(int count) {
  std::string rows;
  for (int v = 0; v < count; ++v) rows += std::to_string(v) + " 0 0\n";
  return rows;
}

/// A file of some vertices and these edges.
std::string with_edges(int vertices, int edges, const std::string& rows) {
  return ply("element vertex " + std::to_string(vertices) + "\n" + xyz + "element edge " +
                 std::to_string(edges) + "\n" + ends,
             points(vertices) + rows);
}

Polylines read_ply(const std::string& bytes) {
  const TemporaryFile file("ply", bytes);
  return read_strands(file.path());
}

}  // namespace

TEST_CASE("a .ply of another program is read, whatever else it holds") {
  const Polylines read = read_ply(
      ply("comment by hand\nobj_info nothing\n"
          "element vertex 3\nproperty uchar red\nproperty double z\nproperty double y\n"
          "property double x\nproperty list uchar int neighbours\n"
          "element face 1\nproperty list uchar uint vertex_indices\n"
          "element edge 2\nproperty int16 vertex2\nproperty uint8 vertex1\nproperty float crease\n",
          "255 3 2 1 0\r\n255 6 5 4.5 2 7 8\n1\n9e0 8 7 1 0\n3 0 1 2\n2 1 0.5\n1 0 0"));
  CHECK(read.vertex_counts == std::vector<int>{3});
  REQUIRE(read.positions.size() == 3);
  CHECK(read.positions[0] == Eigen::Vector3d(1, 2, 3));
  CHECK(read.positions[1] == Eigen::Vector3d(4.5, 5, 6));
  CHECK(read.positions[2] == Eigen::Vector3d(7, 8, 9));
  CHECK(read.radii.empty());
}

TEST_CASE("edges in any order and direction make strands, the lower end first") {
  const Polylines read = read_ply(with_edges(7, 4, "4 3\n6 1\n1 4\n0 5\n"));
  CHECK(read.vertex_counts == std::vector<int>{2, 1, 4});
  std::vector<int> order;
  for (const auto& x : read.positions) order.push_back(static_cast<int>(x.x()));
  CHECK(order == std::vector<int>{0, 5, 2, 3, 4, 1, 6});
}

TEST_CASE("a .ply that is wrong is refused with the reason") {
  const std::string vertex = "element vertex 1\n" + xyz;
  const std::vector<std::pair<std::string, std::string>> table{
      {"", "bytes of header"},
      {"plx\n", "expected the first line 'ply'"},
      {"ply\nend_header\n", "expected a line 'format'"},
      {"ply\nformat binary_big_endian 1.0\nend_header\n", "found 'binary_big_endian'"},
      {"ply\n" + std::string(2000, 'x'), "expected lines of a header"},
      {ply("elment vertex 1\n", ""), "found 'elment'"},
      {ply("property float x\n", ""), "expected 'property TYPE NAME'"},
      {ply("element vertex 1\nproperty flaot x\n", ""), "found 'flaot'"},
      {ply("element vertex -1\n", ""), "found '-1'"},
      {ply("element vertex 1x\n", ""), "found '1x'"},
      {ply("element vertex 9999999999\n", ""), "below 2^31"},
      {ply("element vertex 1\n", "0 0 0"), "expected properties of the element 'vertex'"},
      {ply("element vertex 2000000000\n" + xyz, "0 0 0"), "2000000000 elements 'vertex'"},
      {ply(vertex, "0 0 0"), "expected elements 'edge'"},
      {ply("", ""), "expected elements 'vertex'"},
      {ply("element vertex 1\nproperty float x\n", "0"), "expected a property 'y'"},
      {ply(vertex + "element edge 1\nproperty int vertex1\n", "0 0 0 0"), "property 'vertex2'"},
      {ply(vertex, "0 nan 0"), "finite coordinates, found another as vertex 0"},
      {ply(vertex, "0 1e300 0"), "finite coordinates"},
      {ply(vertex, "0 0 x"), "expected a number, found 'x'"},
      {ply(vertex + "property float radius\n", "0 0 0 -1"), "finite radii >= 0"},
      {with_edges(2, 1, "0 2"), "found vertex 2"},
      {with_edges(2, 1, "0 -1"), "expected numbers of vertices in edge 0"},
      {with_edges(2, 1, "0"), "a number"},
      {with_edges(4, 3, "0 1\n1 2\n1 3"), "of vertex 1: more than two edges"},
      {with_edges(3, 3, "0 1\n1 2\n2 0"), "of vertex 0: its edges form a loop"},
      {with_edges(2, 1, "1 1"), "of vertex 1: its edges form a loop"}};
  for (const auto& [bytes, reason] : table) {
    CAPTURE(bytes);
    CHECK_THAT(reason_against("ply", bytes), Catch::Contains(reason));
  }
}
