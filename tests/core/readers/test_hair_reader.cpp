#include <limits>

#include "tests/core/readers/hostile_file.h"

using namespace ringlet;

namespace {

std::string header(std::uint32_t strands, std::uint32_t points, std::uint32_t arrays,
                   std::uint32_t default_segments) {
  std::string bytes = "HAIR";
  for (const std::uint32_t value : {strands, points, arrays, default_segments}) {
    bytes += bytes_of(value);
  }
  return bytes + std::string(128 - bytes.size(), '\0');
}

const std::vector<float> five_points = {0, 0, 0, 1, 0, 0, 0, 5, 0, 0, 6, 0, 0, 7, 0.5};

// Two strands, of 2 and 3 vertices, with all arrays.
std::string two_strands() {
  return header(2, 5, 31, 0) + bytes_of(std::uint16_t{1}) + bytes_of(std::uint16_t{2}) +
         bytes_of_points(five_points) + bytes_of_points(std::vector<float>(5 + 5 + 15, 0.5f));
}

}  // namespace

TEST_CASE("a .hair file with all arrays is read") {
  const Polylines read = read_as("hair", two_strands());
  CHECK(read.vertex_counts == std::vector<int>{2, 3});
  REQUIRE(read.positions.size() == 5);
  CHECK(read.positions[1] == Eigen::Vector3d(1, 0, 0));
  CHECK(read.positions[4] == Eigen::Vector3d(0, 7, 0.5));
  CHECK(read.radii == std::vector<double>(5, 0.25));
}

TEST_CASE("a .hair file may give the number of segments once for all") {
  const Polylines read =
      read_as("hair", header(2, 4, 2, 1) + bytes_of_points(std::vector<float>(12, 1)));
  CHECK(read.vertex_counts == std::vector<int>{2, 2});
  CHECK(read.radii.empty());
}

TEST_CASE(
    "a .hair file may give the thickness once for all, and no thickness that makes no sense") {
  const auto read = [](float thickness) {
    const std::string head = header(1, 2, 2, 1).replace(20, 4, bytes_of(thickness));
    return read_as("hair", head + bytes_of_points(std::vector<float>(6, 1))).radii;
  };
  CHECK(read(0.5f) == std::vector<double>{0.25, 0.25});
  CHECK(read(-1.0f).empty());
  CHECK(read(std::numeric_limits<float>::quiet_NaN()).empty());
}

TEST_CASE("damaged .hair files are refused, never crashed on") {
  const std::string whole = two_strands();
  for (std::size_t size = 0; size < whole.size(); ++size) {
    CAPTURE(size);
    CHECK(contains(refusal("hair", whole.substr(0, size)), "byte"));
  }
  damage("hair", whole);
}

TEST_CASE("refusals of .hair files say what is wrong") {
  const auto refuse = [](const std::string& bytes) { return refusal("hair", bytes); };
  const float nan = std::numeric_limits<float>::quiet_NaN();
  CHECK(contains(refuse("hair" + two_strands().substr(4)), "expected the magic word 'HAIR'"));
  CHECK(contains(refuse(header(1, 2, 1, 1)), "the file has no points"));
  CHECK(contains(refuse(header(1, 2, 2, 1)),
                 "expected 24 bytes of arrays of 1 strands and 2 points"
                 ", but only 0 are left"));
  CHECK(contains(refuse(header(0xffffffff, 0xffffffff, 31, 0xffffffff)), "bytes of arrays"));
  CHECK(contains(refuse(header(0xffffffff, 0, 2, 0xffffffff)), "no more strands than points"));
  CHECK(contains(refuse(header(1, 2, 2, 0xffffffff) + std::string(24, '\0')),
                 "expected strands of 2 points in all, found more"));
  CHECK(contains(refuse(header(1, 2, 2, 0) + std::string(24, '\0')),
                 "expected strands of 2 points in all, found 1"));
  CHECK(contains(refuse(header(1, 2, 2, 1) + bytes_of_points({0, 0, 0, 1, nan, 0})),
                 "byte 140: expected a vertex with finite coordinates"));
}

TEST_CASE("a file that is not there is refused") {
  CHECK_THROWS_AS(make_plugin<StrandReader>("hair")->read("/nowhere/at/all.hair"), Error);
  CHECK_THROWS_AS(make_plugin<StrandReader>("hair")->read(std::filesystem::temp_directory_path()),
                  Error);
}
