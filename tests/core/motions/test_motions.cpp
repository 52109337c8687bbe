#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/motion.h"
#include "tests/catch.h"
#include "tests/core/read_plugin.h"

using namespace ringlet;

namespace {

std::unique_ptr<Motion> motion(const std::string& text) {
  return make_plugin<Motion>(Json::parse(text));
}

// Two placements are the same if they take the same four points to the same places.
bool near(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  const Eigen::Vector3d points[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  return std::all_of(std::begin(points), std::end(points), [&](const Eigen::Vector3d& point) {
    return (a * point - b * point).norm() < 1e-12;
  });
}

}  // namespace

TEST_CASE("a sinusoid turns about its axis through its centre") {
  const auto swing = motion(R"({"type": "sinusoid", "frequency": 0.5, "angle": 1.2,
      "axis": [0, 0, 3], "centre": [1, 0, 0]})");
  CHECK(near(swing->at(0), Eigen::Isometry3d::Identity()));
  const Eigen::Isometry3d half = swing->at(0.5);  // a quarter of a period
  CHECK((half * Eigen::Vector3d(1, 0, 7)).isApprox(Eigen::Vector3d(1, 0, 7)));
  CHECK((half * Eigen::Vector3d(2, 0, 0))
            .isApprox(Eigen::Vector3d(1 + std::cos(1.2), std::sin(1.2), 0)));
  CHECK(near(swing->at(1), Eigen::Isometry3d::Identity()));
}

TEST_CASE("a sinusoid rests before its start, is held after its end, and starts without a jump") {
  const auto swing = motion(R"({"type": "sinusoid", "frequency": 1, "translation": [0.1, 0, 0],
      "phase": 0.5, "start": 2, "end": 2.3})");
  CHECK(near(swing->at(-5), Eigen::Isometry3d::Identity()));
  CHECK(near(swing->at(2), Eigen::Isometry3d::Identity()));
  const double held = 0.1 * (std::sin(2 * std::numbers::pi * 0.3 + 0.5) - std::sin(0.5));
  CHECK(swing->at(2.3).translation().x() == Approx(held));
  CHECK(near(swing->at(9), swing->at(2.3)));
  CHECK(swing->at(2.15).translation().x() > held);
}

TEST_CASE("the head motion of the paper is a list of sinusoids") {
  // 40 frames settling, then 50-frame leans about z, -z, y, -y, x, -x with 40-frame pauses between:
  // rotation by 0.075 cos(0.6 pi t) rad a frame, t from the start of the lean.
  const double dt = 1.0 / 30;
  const Eigen::Vector3d axes[] = {{0, 0, 1},  {0, 0, -1}, {0, 1, 0},
                                  {0, -1, 0}, {1, 0, 0},  {-1, 0, 0}};
  std::vector<std::unique_ptr<Motion>> parts;
  for (int lean = 0; lean < 6; ++lean) {
    const int first = 40 + 90 * lean;
    const auto& axis = axes[lean];
    parts.push_back(make_plugin<Motion>({{"type", "sinusoid"},
                                         {"frequency", 0.3},
                                         {"angle", 0.075 * 30 / (0.6 * std::numbers::pi)},
                                         {"axis", {axis.x(), axis.y(), axis.z()}},
                                         {"start", first * dt},
                                         {"end", (first + 50) * dt}}));
  }
  Motions motions;
  motions.add("head", std::move(parts));

  double largest = 0;
  for (int frame = 0; frame < 800; ++frame) {
    CAPTURE(frame);
    const Eigen::Isometry3d before = motions.at("head", frame * dt);
    const Eigen::Isometry3d after = motions.at("head", (frame + 1) * dt);
    const Eigen::AngleAxisd turned((after * before.inverse()).rotation());
    largest = std::max(largest, Eigen::AngleAxisd(before.rotation()).angle());
    const int lean = (frame - 40) / 90, in_lean = (frame - 40) % 90;
    if (frame < 40 || lean >= 6 || in_lean >= 50) {
      CHECK(turned.angle() < 1e-7);
      CHECK(before.rotation().isIdentity(1e-9));
    } else {
      const double middle = (in_lean + 0.5) * dt;
      const double expected = 0.075 * std::cos(0.6 * std::numbers::pi * middle);
      CHECK(turned.angle() * turned.axis().dot(axes[lean]) == Approx(expected).epsilon(1e-3));
    }
  }
  CHECK(largest == Approx(1.19).epsilon(0.01));
}

TEST_CASE("keyframes interpolate translations and rotations and are held outside") {
  const auto keys = motion(R"({"type": "keyframes", "times": [1, 2, 4],
      "translations": [[0, 0, 0], [1, 0, 0], [1, 0, 4]],
      "rotations": [[0, 0, 0], [0, 0, 1], [0, 0, 1]], "centre": [0, 1, 0]})");
  CHECK(near(keys->at(0), Eigen::Isometry3d::Identity()));
  const Eigen::Isometry3d half = keys->at(1.5);
  CHECK((half * Eigen::Vector3d(0, 1, 0)).isApprox(Eigen::Vector3d(0.5, 1, 0)));
  CHECK((half * Eigen::Vector3d(1, 1, 0))
            .isApprox(Eigen::Vector3d(0.5 + std::cos(0.5), 1 + std::sin(0.5), 0)));
  CHECK((keys->at(3) * Eigen::Vector3d(0, 1, 0)).isApprox(Eigen::Vector3d(1, 1, 2)));
  CHECK(near(keys->at(2), keys->at(2 - 1e-14)));
  CHECK(near(keys->at(99), keys->at(4)));
}

TEST_CASE("keyframes may turn about changing axes, at constant speed") {
  const auto keys = motion(R"({"type": "keyframes", "times": [0, 1],
      "rotations": [[1.5, 0, 0], [0, 1.5, 0]]})");
  const Eigen::Matrix3d whole = (keys->at(1) * keys->at(0).inverse()).rotation();
  const Eigen::Matrix3d quarter = (keys->at(0.25) * keys->at(0).inverse()).rotation();
  CHECK(Eigen::AngleAxisd(quarter).angle() == Approx(Eigen::AngleAxisd(whole).angle() / 4));
}

TEST_CASE("a single key is a fixed placement") {
  const auto keys = motion(R"({"type": "keyframes", "times": [1], "translations": [[1, 2, 3]]})");
  CHECK(keys->at(0).translation() == Eigen::Vector3d(1, 2, 3));
  CHECK(keys->at(5).translation() == Eigen::Vector3d(1, 2, 3));
}

TEST_CASE("bad parameters of motions are reported") {
  const auto read = [](const std::string& text) { return read_plugin<Motion>(Json::parse(text)); };
  CHECK(read(R"({"type": "sinusoid", "angle": 1})").has_one_problem("/frequency", "missing"));
  CHECK(read(R"({"type": "sinusoid", "angle": 1, "frequency": 0})")
            .has_one_problem("/frequency", "> 0 in Hz"));
  CHECK(read(R"({"type": "sinusoid", "frequency": 1})").has_one_problem("", "moves nothing"));
  CHECK(read(R"({"type": "sinusoid", "angle": 1, "frequency": 1, "axis": [0, 0, 0]})")
            .has_one_problem("/axis", "other than zero"));
  CHECK(read(R"({"type": "sinusoid", "angle": 1, "frequency": 1, "start": 2, "end": 1})")
            .has_one_problem("/end", "expected a time after start, 2.0 s, found 1.0"));
  CHECK(read(R"({"type": "keyframes", "times": []})").problems.size() == 2);
  CHECK(read(R"({"type": "keyframes", "times": [0, 2, 2], "rotations": [[0,0,0],[0,0,1],[0,0,2]]})")
            .has_one_problem("/times/2", "after the one before it, 2.0 s, found 2.0"));
  CHECK(read(R"({"type": "keyframes", "times": [0, 1], "translations": [[0, 0, 0]]})")
            .has_one_problem("/translations", "each of the 2 times"));
  CHECK(read(R"({"type": "keyframes", "times": [0, 1], "rotations": [[0, 0, 0]]})")
            .has_one_problem("/rotations", "each of the 2 times"));
}

TEST_CASE("displacements are those between two times, whichever motion was asked for before") {
  const char* sinusoid = R"({"type": "sinusoid", "frequency": 0.5, "angle": 1.2,
      "axis": [0, 0, 3], "centre": [1, 0, 0]})";
  const char* wave = R"({"type": "sinusoid", "frequency": 1, "translation": [0.1, 0, 0]})";
  Motions motions;
  for (const auto& [name, text] : {std::pair{"turn", sinusoid}, std::pair{"shift", wave}}) {
    std::vector<std::unique_ptr<Motion>> parts;
    parts.push_back(motion(text));
    motions.add(name, std::move(parts));
  }
  Displacements displacements(motions, 0.2, 0.7);
  const Eigen::Isometry3d& first = displacements.by("turn");
  for (const char* name : {"turn", "turn", "shift", "turn", "", "shift"}) {
    CHECK(near(displacements.by(name) * motions.at(name, 0.2), motions.at(name, 0.7)));
    CHECK_THROWS_AS(displacements.by("unknown"), Error);
  }
  CHECK(&first == &displacements.by("turn"));
  CHECK_FALSE(near(first, displacements.by("shift")));
}
