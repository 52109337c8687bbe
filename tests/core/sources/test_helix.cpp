#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/strand_source.h"
#include "tests/catch.h"
#include "tests/core/read_plugin.h"

using namespace ringlet;

namespace {

// The wisp "type 4C" of the paper.
Json wisp() {
  return Json::parse(R"({"type": "helix", "vertices": 101, "curl_radius": 0.005, "pitch": 0.005,
      "segments_per_turn": 5, "stem_vertices": 3, "stem_spacing": 0.01})");
}

StrandSet generate(const Json& json) { return make_plugin<StrandSource>(json)->generate(); }

double angle_at(const std::vector<Eigen::Vector3d>& x, int v) {
  const Eigen::Vector3d e0 = x[v - 1] - x[v], e1 = x[v + 1] - x[v];
  return std::atan2(e0.cross(e1).norm(), e0.dot(e1));
}

double torsion_at(const std::vector<Eigen::Vector3d>& x, int v) {
  const Eigen::Vector3d e1 = (x[v + 1] - x[v]).normalized();
  const Eigen::Vector3d u = (x[v - 1] - x[v]).cross(e1), w = (x[v + 2] - x[v + 1]).cross(e1);
  return std::atan2(e1.dot(u.cross(w)), u.dot(w));
}

}  // namespace

TEST_CASE("the paper's wisp has the paper's measures") {
  const StrandSet set = generate(wisp());
  REQUIRE(set.vertex_counts == std::vector<int>{101});
  const auto& x = set.positions;
  REQUIRE(x.size() == 101);

  CHECK((x[1] - x[0]).norm() == Approx(0.01));
  CHECK((x[2] - x[1]).norm() == Approx(0.01));
  CHECK(angle_at(x, 1) == Approx(std::numbers::pi));
  double turned = 0;
  for (int v = 2; v < 100; ++v) {
    CAPTURE(v);
    CHECK((x[v + 1] - x[v]).norm() == Approx(5.96e-3).epsilon(1e-3));
    if (v > 2) CHECK(angle_at(x, v) == Approx(1.9055).epsilon(1e-4));
    if (v > 2 && v < 99) CHECK(std::abs(torsion_at(x, v)) == Approx(0.2425).epsilon(1e-3));
    CHECK(std::hypot(x[v].x(), x[v].z()) == Approx(0.005));
    const Eigen::Vector3d from(x[v].x(), 0, x[v].z()), to(x[v + 1].x(), 0, x[v + 1].z());
    turned += std::atan2(from.cross(to).norm(), from.dot(to));
  }
  CHECK(turned / (2 * std::numbers::pi) == Approx(19.6));
  // 98 segments of 1 mm; the paper counts 9.9 cm from the vertex before the helix.
  CHECK(x[100].y() - x[2].y() == Approx(0.098));
}

TEST_CASE("handedness mirrors the torsion of a helix") {
  Json json = wisp();
  const double right = torsion_at(generate(json).positions, 50);
  json["handedness"] = "left";
  const double left = torsion_at(generate(json).positions, 50);
  CHECK(left == Approx(-right));
  CHECK(std::abs(right) > 0.2);
}

TEST_CASE("a right-handed helix advances like a right-handed screw") {
  const auto x = generate({{"type", "helix"}, {"vertices", 3}}).positions;
  CHECK(x[0].cross(x[1]).y() > 0);
  CHECK(x[1].y() > x[0].y());
}

TEST_CASE("a stem of one vertex is no stem") {
  Json json = wisp();
  json["stem_vertices"] = 0;
  const auto none = generate(json).positions;
  json["stem_vertices"] = 1;
  CHECK(generate(json).positions == none);
  CHECK(none[0].isApprox(Eigen::Vector3d(0.005, 0, 0)));
}

TEST_CASE("a helix winds about the direction of its root") {
  Json json = wisp();
  const Eigen::Vector3d root(1, 2, 3), direction = Eigen::Vector3d(1, -2, 0.5).normalized();
  json["roots"] = {{"type", "point"}, {"position", {1, 2, 3}}, {"direction", {1, -2, 0.5}}};
  for (const Eigen::Vector3d& x : generate(json).positions) {
    CHECK((x - root).cross(direction).norm() == Approx(0.005));
  }
}

TEST_CASE("a helix can grow straight down") {
  Json json = wisp();
  json["roots"] = {{"type", "point"}, {"direction", {0, -1, 0}}};
  const auto x = generate(json).positions;
  CHECK(x.back().y() == Approx(-0.118));
  CHECK(torsion_at(x, 50) == Approx(torsion_at(generate(wisp()).positions, 50)));
}

TEST_CASE("random turns are about the strand's own axis, seeded, and of each strand") {
  Json json = wisp();
  json["count"] = 3;
  json["random_turn"] = true;
  json["seed"] = 7;
  const StrandSet first = generate(json), again = generate(json);
  CHECK(first.positions == again.positions);
  CHECK_FALSE(first.positions[0].isApprox(first.positions[101], 1e-3));
  CHECK_FALSE(first.positions[101].isApprox(first.positions[202], 1e-3));
  for (int v = 0; v < 101; ++v) {
    CHECK(first.positions[v].y() == Approx(first.positions[101 + v].y()));
  }
  json["seed"] = 8;
  CHECK_FALSE(generate(json).positions[0].isApprox(first.positions[0], 1e-3));
}

TEST_CASE("the pins and motion of generated strands are what the scene says") {
  const StrandSet set = generate(
      {{"type", "helix"}, {"count", 2}, {"vertices", 5}, {"pinned", 4}, {"motion", "nod"}});
  CHECK(set.pinned_counts == std::vector<int>{4, 4});
  CHECK(set.motions == std::vector<std::string>{"nod", "nod"});
}

TEST_CASE("every bad parameter of a helix is reported where it stands") {
  const auto with = [](const char* key, const Json& value) {
    return read_plugin<StrandSource>(Json{{"type", "helix"}, {key, value}});
  };
  CHECK(with("count", 0).has_one_problem("/count", "[1, 1e+08]"));
  CHECK(with("count", 100'000'000).has_one_problem("/count", "2^31 vertices"));
  CHECK(with("vertices", 1).has_one_problem("/vertices", ">= 2"));
  CHECK(with("vertices", 10.5).has_one_problem("/vertices", "integer"));
  CHECK(with("curl_radius", 0).has_one_problem("/curl_radius", "> 0 in m"));
  CHECK(with("pitch", -1).has_one_problem("/pitch", "> 0 in m"));
  CHECK(with("segments_per_turn", 2).has_one_problem("/segments_per_turn", "> 2"));
  CHECK(with("handedness", "both").has_one_problem("/handedness", "'right' 'left'"));
  CHECK(with("stem_vertices", -1).has_one_problem("/stem_vertices", ">= 0"));
  CHECK(with("stem_vertices", 101).has_one_problem("/stem_vertices", "fewer than the 101"));
  CHECK(with("stem_spacing", 0).has_one_problem("/stem_spacing", "> 0 in m"));
  CHECK(with("random_turn", 1).has_one_problem("/random_turn", "true or false"));
  CHECK(with("pinned", 102).has_one_problem("/pinned", "at most the 101"));
  CHECK(with("pinned", -1).has_one_problem("/pinned", ">= 0"));
  CHECK(with("motion", "nood").has_one_problem("/motion", "did you mean 'nod'"));
  CHECK(with("seed", -1).has_one_problem("/seed", ">= 0"));
  CHECK(with("roots", "spere").has_one_problem("/roots/type", "did you mean 'sphere'"));
  CHECK(with("radius", 1).has_one_problem("/radius", "unknown key"));
}
