#include "core/strand_source.h"
#include "tests/catch.h"
#include "tests/core/read_plugin.h"

using namespace ringlet;

TEST_CASE("explicit strands are the vertices of the scene") {
  const Json json = Json::parse(R"({"type": "explicit", "pinned": 3, "motion": "nod",
      "strands": [[[0, 0, 0], [1, 2, 3]], [[0, 0, 0], [0, 1, 0], [0, 2, 0.5], [0, 3, 0]]]})");
  const StrandSet set = make_plugin<StrandSource>(json)->generate();
  CHECK(set.vertex_counts == std::vector<int>{2, 4});
  REQUIRE(set.positions.size() == 6);
  CHECK(set.positions[1] == Eigen::Vector3d(1, 2, 3));
  CHECK(set.positions[4] == Eigen::Vector3d(0, 2, 0.5));
  CHECK(set.pinned_counts == std::vector<int>{2, 3});
  CHECK(set.motions == std::vector<std::string>{"nod", "nod"});
}

TEST_CASE("the echo of explicit strands reads back as the same strands") {
  const Json json = Json::parse(R"({"type": "explicit", "strands": [[[0, 0, 0], [1, 0.1, 3]]]})");
  const Json echo = read_plugin<StrandSource>(json).choice.resolved();
  CHECK(make_plugin<StrandSource>(echo)->generate().positions[1] == Eigen::Vector3d(1, 0.1, 3));
}

TEST_CASE("every problem of explicit strands is reported, with its pointer") {
  const auto read = read_plugin<StrandSource>(Json::parse(R"({"type": "explicit", "pinned": -1,
      "strands": [[[0, 0, 0], [1, 2]], [[0, 0, 0]], 7, [[0, 0, "0"], [1, 1, 1], [1, 1, 1]]]})"));
  REQUIRE(read.problems.size() == 6);
  CHECK(read.problems[0].pointer == "/strands/0/1");
  CHECK(read.problems[0].message == "expected vertex [x, y, z] in m, found [1,2]");
  CHECK(read.problems[1].pointer == "/strands/1");
  CHECK(read.problems[1].message ==
        "expected a strand of at least 2 vertices [[x, y, z], ...] in m, found 1");
  CHECK(read.problems[2].pointer == "/strands/2");
  CHECK(read.problems[3].pointer == "/strands/3/0");
  CHECK(read.problems[4].pointer == "/strands/3/2");
  CHECK(read.problems[4].message ==
        "expected a vertex apart from the one before it, found the same");
  CHECK(read.problems[5].pointer == "/pinned");
}

TEST_CASE("no strands at all are refused") {
  const auto empty =
      read_plugin<StrandSource>(Json::parse(R"({"type": "explicit", "strands": []})"));
  CHECK(empty.has_one_problem("/strands", "at least one strand"));
  const auto absent = read_plugin<StrandSource>(Json::parse(R"({"type": "explicit"})"));
  CHECK(absent.has_one_problem("/strands", "missing"));
}
