#include <limits>

#include "tests/core/readers/hostile_file.h"

using namespace ringlet;

namespace {

// A strand of two vertices, a bald spot, and a strand of three.
std::string three_strands() {
  return bytes_of(std::int32_t{3}) + bytes_of(std::int32_t{2}) +
         bytes_of_points({0, 0, 0, 1, 2, 3}) + bytes_of(std::int32_t{1}) +
         bytes_of_points({9, 9, 9}) + bytes_of(std::int32_t{3}) +
         bytes_of_points({0, 5, 0, 0, 6, 0, 0, 7, 0.5});
}

}  // namespace

TEST_CASE("a .data file is read, bald spots as single vertices") {
  const Polylines read = read_as("data", three_strands());
  CHECK(read.vertex_counts == std::vector<int>{2, 1, 3});
  REQUIRE(read.positions.size() == 6);
  CHECK(read.positions[1] == Eigen::Vector3d(1, 2, 3));
  CHECK(read.positions[5] == Eigen::Vector3d(0, 7, 0.5));
}

TEST_CASE("damaged .data files are refused, never crashed on") {
  const std::string whole = three_strands();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    CAPTURE(size);
    CHECK(contains(refusal("data", whole.substr(0, size)), "byte"));
  }
  damage("data", whole);
}

TEST_CASE("refusals of .data files say what is wrong") {
  const auto refuse = [](const std::string& bytes) { return refusal("data", bytes); };
  const float infinity = std::numeric_limits<float>::infinity();
  CHECK(contains(refuse(bytes_of(std::int32_t{-1})), "expected a number of strands, found -1"));
  CHECK(contains(refuse(bytes_of(std::numeric_limits<std::int32_t>::max())),
                 "expected 8589934588 bytes of 2147483647 strands, but only 0 are left"));
  CHECK(contains(refuse(bytes_of(std::int32_t{1}) + bytes_of(std::int32_t{-5})),
                 "expected a number of vertices, found -5"));
  CHECK(contains(refuse(bytes_of(std::int32_t{1}) + bytes_of(std::int32_t{1 << 30})),
                 "bytes of 1073741824 vertices"));
  CHECK(contains(refuse(bytes_of(std::int32_t{1}) + bytes_of(std::int32_t{1}) +
                        bytes_of_points({0, infinity, 0})),
                 "byte 8: expected a vertex with finite coordinates"));
  CHECK(contains(refuse(three_strands() + "x"), "expected the end of the file after 3 strands"));
}
