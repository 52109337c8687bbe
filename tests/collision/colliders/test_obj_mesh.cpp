#include <algorithm>

#include "collision/colliders/obj_mesh.h"
#include "core/error.h"
#include "tests/catch.h"
#include "tests/temporary_file.h"

using namespace ringlet;

namespace {

IndexedTriangles read(const std::string& text) {
  return read_obj_mesh(TemporaryFile("obj", text).path());
}

const std::string corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

// Whether reading a text ends in a complaint that contains all of some words.
bool refuses(const std::string& text, const std::vector<std::string>& words) {
  try {
    read(text);
  } catch (const Error& error) {
    const std::string complaint = error.what();
    return std::all_of(words.begin(), words.end(), [&](const std::string& word) {
      return complaint.find(word) != std::string::npos;
    });
  }
  return false;
}

}  // namespace

TEST_CASE("obj: triangles, indices of all spellings, and what is ignored") {
  using Triangles = std::vector<std::array<int, 3>>;
  const Triangles one{{0, 1, 2}};
  CHECK(read(corners + "f 1 2 3\n").triangles == one);
  CHECK(read(corners + "f 1/5 2/6 3/7").triangles == one);
  CHECK(read(corners + "f 1//5 2//6 3//7\r\n").triangles == one);
  CHECK(read(corners + "f 1/5/9 2/6/9 3/7/9\n").triangles == one);
  CHECK(read(corners + "f -4 -3 -2\n").triangles == one);
  CHECK(read(corners + "f 1 2 3 # the first\n").triangles == one);
  CHECK(read("# a mesh\no body\nvn 0 0 1\nvt 0 0\n" + corners +
             "usemtl skin\ns off\nf 1 2 3\nv 9 9 9\n")
            .triangles == one);
  const IndexedTriangles mesh = read("v 1e-3 -2.5 +0\nv 0 0 0 1.0\nv\t1 1 1\nf 1 2 3");
  CHECK(mesh.vertices[0] == Eigen::Vector3d(1e-3, -2.5, 0));
  CHECK(mesh.vertices[2] == Eigen::Vector3d(1, 1, 1));
}

TEST_CASE("obj: polygons become fans") {
  const auto triangles = read(corners + "v 0 2 0\nf 1 2 3 4 5\n").triangles;
  CHECK(triangles == std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}});
}

TEST_CASE("obj: hostile input is refused with line and reason") {
  CHECK(refuses(corners + "f 1 2 5\n", {"line 5", "vertex 5"}));
  CHECK(refuses(corners + "f 1 2 -5\n", {"line 5", "vertex -5"}));
  CHECK(refuses(corners + "f 0 1 2\n", {"line 5"}));
  CHECK(refuses("f 1 2 3\n" + corners, {"line 1"}));
  CHECK(refuses(corners + "f 1 2 99999999999999999999\n", {"line 5"}));
  CHECK(refuses(corners + "f 1 2 9223372036854775807\n", {"line 5"}));
  CHECK(refuses(corners + "f 1 2 -9223372036854775808\n", {"line 5"}));
  CHECK(refuses(corners + "f 1 2 x\n", {"found 'x'"}));
  CHECK(refuses(corners + "f 1 2 /3\n", {"found '/3'"}));
  CHECK(refuses(corners + "f 1 2\n", {"three vertices"}));
  CHECK(refuses(corners + "f\n", {"three vertices"}));
  CHECK(refuses("v 0 nan 0\n", {"line 1", "'nan'"}));
  CHECK(refuses("v 0 inf 0\n", {"'inf'"}));
  CHECK(refuses("v 0 1e400 0\n", {"'1e400'"}));
  CHECK(refuses("v 0 1e300 0\n", {"'1e300'"}));
  CHECK(refuses("v 0 1\n", {"three coordinates"}));
  CHECK(refuses("v 0 1 2z\n", {"'2z'"}));
  CHECK(refuses(corners + "v 0 0", {"line 5"}));  // cut off
  CHECK(refuses("", {"no face"}));
  CHECK(refuses(corners, {"no face"}));
  CHECK(refuses(std::string(1000, '\0'), {"no face"}));
  CHECK_THROWS_AS(read_obj_mesh("/nowhere/mesh.obj"), Error);
}
