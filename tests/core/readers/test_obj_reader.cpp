#include "tests/core/readers/hostile_file.h"

using namespace ringlet;

namespace {

const std::string two_polylines =
    "# two strands\n"
    "v 0 0 0\nv 1 0 0\nv 1.5e0 +0.5 -2\r\n"
    "l 1 2 3\n"
    "v\t5 5 5 1.0\n"
    "l -1 3/1\n"
    "f 1 2 3\n";

}  // namespace

TEST_CASE("polylines of an .obj file are read") {
  std::string plain = two_polylines;
  const Polylines read = read_as("obj", plain);
  CHECK(read.vertex_counts == std::vector<int>{3, 2});
  REQUIRE(read.positions.size() == 5);
  CHECK(read.positions[2] == Eigen::Vector3d(1.5, 0.5, -2));
  CHECK(read.positions[3] == Eigen::Vector3d(5, 5, 5));
  CHECK(read.positions[4] == Eigen::Vector3d(1.5, 0.5, -2));
}

TEST_CASE("a polyline may name vertices further down, and go on on the next line") {
  const Polylines read = read_as("obj", "l 1 \\\n 2 3 # to the tip\nv 0 0 0\nv 1 0 0\nv 2 0 0");
  CHECK(read.vertex_counts == std::vector<int>{3});
}

TEST_CASE("single edges that follow each other are one strand") {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 4 0 0\n";
  CHECK(read_as("obj", vertices + "l 1 2\nl 2 3\nl 4 5\n").vertex_counts == std::vector<int>{3, 2});
  CHECK(read_as("obj", vertices + "l 1 2 3\nl 3 4\nl 4 5\n").vertex_counts ==
        std::vector<int>{3, 3});
}

TEST_CASE("damaged .obj files are read or refused, never crashed on") {
  damage("obj", two_polylines);
  CHECK(contains(refusal("obj", two_polylines.substr(0, 30)), "found none"));
  CHECK(refusal("obj", two_polylines.substr(0, two_polylines.size() - 8)).empty());
}

TEST_CASE("refusals of .obj files say what is wrong, and in which line") {
  const auto refuse = [](const std::string& bytes) { return refusal("obj", bytes); };
  CHECK(contains(refuse(""), "expected polylines"));
  CHECK(contains(refuse("v 0 0 0\nv 1 0\nl 1 2"), "line 2: expected a vertex 'v x y z'"));
  CHECK(contains(refuse("v 0 0 0\nv 1 nan 0\nl 1 2"),
                 "line 2: expected a finite number, found "
                 "'nan'"));
  CHECK(contains(refuse("v 0 0 inf\n"), "found 'inf'"));
  CHECK(contains(refuse("v 0 0 1e300\n"), "found '1e300'"));
  CHECK(contains(refuse("v 0 0 1e999\n"), "found '1e999'"));
  CHECK(contains(refuse("v 0 0 1x\n"), "found '1x'"));
  CHECK(contains(refuse("v 0 0 0\n\nl 1 2"),
                 "line 3: expected a polyline of the file's 1 vertices, "
                 "found vertex 2"));
  CHECK(contains(refuse("v 0 0 0\nl 1 \\\n1\nl 1 -2"), "line 4"));
  CHECK(contains(refuse("v 0 0 0\nl 0 1"), "found '0'"));
  CHECK(contains(refuse("v 0 0 0\nl 1 99999999999999999999"), "expected the number of a vertex"));
  CHECK(contains(refuse("v 0 0 0\nl 1 -9223372036854775808"), "line 2"));
}

TEST_CASE("polylines without vertices are strands of none") {
  CHECK(read_as("obj", "l\nl # 1\nl #a b\nl #a b").vertex_counts == std::vector<int>{0, 0, 0, 0});
}
