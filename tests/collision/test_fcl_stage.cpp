#include <tbb/global_control.h>

#include <Eigen/Eigenvalues>

#include "collision/segment_gap.h"
#include "core/collision_stage.h"
#include "core/system_matrix.h"
#include "tests/catch.h"
#include "tests/collision/make_plugin.h"
#include "tests/collision/random_strands.h"

using namespace ringlet;

namespace {

/// Strands and a stage bound to them, nothing pinned.
struct Scenery {
  Strands strands;
  StrandGroups groups{strands};
  Motions motions;
  VertexScalars free;
  VertexField x;
  std::unique_ptr<CollisionStage> stage;

  Scenery(Strands given, const std::string& json) : strands(std::move(given)) {
    stage = make_plugin<CollisionStage>(Json::parse(json));
    free.assign(groups.rows(), Pack(1));
    x = positions_with_pads(groups, rest_positions(strands));
  }
  void start() {
    stage->bind(strands, groups, motions);
    stage->set_free(free);
    stage->begin_step(x, 0, 0.01);
    stage->detect(x);
  }
  VertexField gradient_at(const VertexField& at) {
    VertexField gradient(groups);
    Couplings couplings(groups);
    stage->add(at, &couplings);
    couplings.finish(free);
    for (int g = 0; g < groups.count(); ++g) couplings.add_gradient(g, gradient.group(g));
    return gradient;
  }
  Eigen::MatrixXd hessian_at(const VertexField& at) {
    SystemMatrix matrix(groups);
    matrix.keep_bands();
    stage->add(at, &matrix.couplings);
    matrix.couplings.finish(free);
    for (int g = 0; g < groups.count(); ++g) {
      matrix.couplings.add_to_bands(g, matrix.bands.group(g));
    }
    const int n = 3 * strands.vertex_count();
    Eigen::MatrixXd dense(n, n);
    for (int column = 0; column < n; ++column) {
      VertexField unit(groups), product(groups);
      unit.set(column / 3, Eigen::Vector3d::Unit(column % 3));
      multiply(matrix, unit, product);
      dense.col(column) = product.matrix().reshaped();
    }
    return dense;
  }
};

/// A turn about the x axis, half a radian a second.
class Nod final : public Motion {
 public:
  Eigen::Isometry3d at(double time) const override {
    return Eigen::Isometry3d(Eigen::AngleAxisd(0.5 * time, Eigen::Vector3d::UnitX()));
  }
};

void add_nod(Motions& motions) {
  std::vector<std::unique_ptr<Motion>> parts;
  parts.push_back(std::make_unique<Nod>());
  motions.add("nod", std::move(parts));
}

const char* const bundle_stage =
    R"({"type": "fcl", "thickness": 2e-3, "stiffness": 3, "push_at_rest": true,
  "colliders": [{"type": "sphere", "radius": 0.01}, {"type": "plane", "normal": [0, 0, 1]}]})";

}  // namespace

TEST_CASE("the stage's energy is the sum over all pairs of edges that are near") {
  std::mt19937 random(19);
  Scenery s(random_bundle(random, 30),
            R"({"type": "fcl", "thickness": 2e-3, "stiffness": 3, "push_at_rest": true})");
  s.start();
  const Points x = rest_positions(s.strands);
  std::vector<double> arc(x.size(), 0);
  double expected = 0, deepest = 0;
  int contacts = 0;
  for (std::size_t v = 1; v < x.size(); ++v) {
    arc[v] = arc[v - 1] + (x[v] - x[v - 1]).norm();
  }
  const auto is_edge = [&](int v) {
    return v + 1 < s.strands.vertex_count() && s.strands.strand_of(v) == s.strands.strand_of(v + 1);
  };
  for (int a = 0; a < s.strands.vertex_count(); ++a) {
    for (int b = a + 2; b < s.strands.vertex_count(); ++b) {
      if (!is_edge(a) || !is_edge(b)) continue;
      const bool same = s.strands.strand_of(a) == s.strands.strand_of(b);
      if (same && arc[b] - arc[a + 1] < 4e-3) continue;  // the default: twice the thickness
      const double depth = 2e-3 - segment_gap({x[a], x[a + 1], x[b], x[b + 1]}).distance;
      if (depth <= 0) continue;
      expected += 0.5 * 3 * depth * depth;
      deepest = std::max(deepest, depth);
      ++contacts;
    }
  }
  REQUIRE(contacts > 10);
  CHECK(s.stage->add(s.x, nullptr) == Approx(expected));
  CHECK(s.stage->report().strand_contacts == contacts);
  CHECK(s.stage->report().collider_contacts == 0);
  CHECK(s.stage->report().penetration == Approx(deepest));
}

TEST_CASE("the stage's gradient is that of differences along random directions") {
  const unsigned seed = 23;
  CAPTURE(seed);
  std::mt19937 random(seed);
  Scenery s(random_bundle(random, 20), bundle_stage);
  s.start();
  const VertexField gradient = s.gradient_at(s.x);
  CHECK(s.stage->report().strand_contacts > 5);
  CHECK(s.stage->report().collider_contacts > 20);
  for (int trial = 0; trial < 5; ++trial) {
    VertexField direction(s.groups), plus = s.x, minus = s.x;
    for (int v = 0; v < s.strands.vertex_count(); ++v) direction.set(v, random_point(random, 1));
    const double step = 1e-8;
    add_scaled(plus, step, direction);
    add_scaled(minus, -step, direction);
    const double difference =
        (s.stage->add(plus, nullptr) - s.stage->add(minus, nullptr)) / (2 * step);
    CHECK(dot(gradient, direction) == Approx(difference).epsilon(1e-4));
  }
}

TEST_CASE("contacts follow positions and colliders, whatever was asked for before") {
  std::mt19937 random(27);
  const Strands strands = random_bundle(random, 20);
  const char* const json =
      R"({"type": "fcl", "thickness": 2e-3, "stiffness": 3, "push_at_rest": true,
          "colliders": [{"type": "plane", "normal": [0, 1, 0], "motion": "nod"}]})";
  Scenery s(strands, json);
  add_nod(s.motions);
  s.start();
  VertexField other = s.x;
  for (int v = 0; v < s.strands.vertex_count(); ++v) other.add(v, random_point(random, 2e-4));
  const auto fresh = [&](const VertexField& at, double time) {
    Scenery f(strands, json);
    add_nod(f.motions);
    f.start();
    f.stage->begin_step(f.x, time, 0.01);
    f.stage->detect(at);
    return f.stage->add(at, nullptr);
  };
  const double here = s.stage->add(s.x, nullptr), there = s.stage->add(other, nullptr);
  REQUIRE(here != there);
  CHECK(here == fresh(s.x, 0));
  CHECK(there == fresh(other, 0));
  CHECK(s.stage->add(other, nullptr) == there);
  s.stage->detect(other);
  const VertexField gradient = s.gradient_at(other);
  CHECK(dot(gradient, gradient) > 0);
  CHECK(s.stage->add(s.x, nullptr) == here);
  // So little that the candidates stay; then more.
  for (const double time : {0.01, 0.4}) {
    s.stage->begin_step(s.x, time, 0.01);
    s.stage->detect(s.x);
    CHECK(s.stage->add(s.x, nullptr) == fresh(s.x, time));
    CHECK(s.stage->add(s.x, nullptr) != here);
  }
}

TEST_CASE("the stage's Hessian is symmetric and semi-definite") {
  std::mt19937 random(29);
  Scenery s(random_bundle(random, 8), bundle_stage);
  s.start();
  const Eigen::MatrixXd hessian = s.hessian_at(s.x);
  CHECK(hessian.norm() > 1);
  CHECK((hessian - hessian.transpose()).norm() < 1e-12 * hessian.norm());
  const Eigen::VectorXd eigenvalues =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(hessian).eigenvalues();
  CHECK(eigenvalues.minCoeff() > -1e-10 * eigenvalues.maxCoeff());
}

TEST_CASE("two edges far from parallel: the Hessian along the normal is that of differences") {
  Scenery s(Strands({2, 2}, {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0.05}, {0, 1, 0.05}}, Material{}),
            R"({"type": "fcl", "thickness": 0.1, "stiffness": 3, "push_at_rest": true})");
  s.start();
  VertexField along(s.groups), moved = s.x;
  for (int v = 0; v < 2; ++v) along.set(v, {0, 0, 1});
  add_scaled(moved, 1e-6, along);
  const Eigen::VectorXd slope =
      (s.gradient_at(moved).matrix() - s.gradient_at(s.x).matrix()).reshaped() / 1e-6;
  const Eigen::VectorXd product = s.hessian_at(s.x) * along.matrix().reshaped();
  CHECK((product - slope).norm() < 1e-6 * slope.norm());
  CHECK(slope.norm() > 1);
}

TEST_CASE("nothing pushes beyond the thickness, and crossing strands get a finite force") {
  const char* const json =
      R"({"type": "fcl", "thickness": 0.1, "stiffness": 2, "push_at_rest": true})";
  Scenery apart(Strands({2, 2}, {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0.11}, {0, 1, 0.11}}, Material{}),
                json);
  apart.start();
  CHECK(apart.stage->add(apart.x, nullptr) == 0);
  CHECK(apart.stage->report().strand_contacts == 0);

  Scenery crossing(Strands({2, 2}, {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}}, Material{}),
                   json);
  crossing.start();
  CHECK(crossing.stage->add(crossing.x, nullptr) == Approx(0.01));
  const VertexField gradient = crossing.gradient_at(crossing.x);
  CHECK(gradient.get(0).norm() == Approx(0.1));  // half of k h, on each end
  CHECK((gradient.get(0) + gradient.get(2)).norm() < 1e-12);
}

TEST_CASE("edges in contact at rest push only where they come nearer than the slack allows") {
  Scenery s(Strands({2, 2, 2},
                    {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0.04}, {0, 1, 0.04}, {3, -1, 0.5}, {3, 1, 0.5}},
                    Material{}),
            R"({"type": "fcl", "thickness": 0.1, "stiffness": 2, "rest_slack": 0.2})");
  s.start();
  for (const double z : {0.0, -0.007}) {
    for (const int v : {2, 3}) s.x.add(v, {0, 0, z});
    CHECK(s.stage->add(s.x, nullptr) == 0);
    CHECK(s.stage->report().strand_contacts == 0);
  }
  for (const int v : {2, 3}) s.x.add(v, {0, 0, -0.005});
  CHECK(s.stage->add(s.x, nullptr) == Approx(0.004 * 0.004).epsilon(1e-3));

  for (const int v : {4, 5})
    s.x.add(v, {-2.5, 0, -0.41});  // not near at rest: all of the thickness
  s.stage->detect(s.x);
  CHECK(s.stage->add(s.x, nullptr) == Approx(0.004 * 0.004 + 0.01 * 0.01).epsilon(1e-2));
}

TEST_CASE("strands feel each other only if they are asked to") {
  std::mt19937 random(31);
  Scenery s(random_bundle(random, 20),
            R"({"type": "fcl", "thickness": 2e-3, "strand_contacts": false,
    "colliders": [{"type": "sphere", "radius": 0.01}]})");
  s.start();
  CHECK(s.stage->add(s.x, nullptr) > 0);
  CHECK(s.stage->report().strand_contacts == 0);
  CHECK(s.stage->report().collider_contacts > 0);
}

TEST_CASE(
    "a vertex is held half a thickness away from a collider, with its own stiffness if asked") {
  const Strands strands({2}, {{0, 0, 0.014}, {0, 0, 0.05}}, Material{});
  Scenery s(strands, R"({"type": "fcl", "thickness": 0.01, "stiffness": 2,
    "colliders": [{"type": "sphere", "radius": 0.01}]})");
  s.start();
  CHECK(s.stage->add(s.x, nullptr) == Approx(0.5 * 2 * 0.001 * 0.001));
  CHECK((s.gradient_at(s.x).get(0) - Eigen::Vector3d(0, 0, -0.002)).norm() < 1e-12);

  Scenery other(strands, R"({"type": "fcl", "collider_thickness": 0.006, "collider_stiffness": 5,
    "colliders": [{"type": "sphere", "radius": 0.01}]})");
  other.start();
  CHECK(other.stage->add(other.x, nullptr) == Approx(0.5 * 5 * 0.002 * 0.002));
}

TEST_CASE("colliders move to where they are at the end of the step") {
  Scenery s(Strands({2}, {{0, 0, 1}, {0, 0, 1.5}}, Material{}),
            R"({"type": "fcl", "thickness": 0.02, "stiffness": 2, "colliders":
               [{"type": "sphere", "radius": 0.1, "centre": [0, 0, 1.105], "motion": "nod"}]})");
  add_nod(s.motions);
  s.start();
  CHECK(s.stage->add(s.x, nullptr) == Approx(0.5 * 2 * 0.005 * 0.005));
  s.stage->begin_step(s.x, 0.4, 0.4);
  s.stage->detect(s.x);
  CHECK(s.stage->add(s.x, nullptr) == 0);

  const Eigen::Isometry3d moved = Nod().at(0.4);
  s.x.set(0, moved * Eigen::Vector3d(0, 0, 1));
  s.stage->detect(s.x);
  CHECK(s.stage->add(s.x, nullptr) == Approx(0.5 * 2 * 0.005 * 0.005));
  const Eigen::Vector3d push = moved.linear() * Eigen::Vector3d(0, 0, 0.01);
  CHECK((s.gradient_at(s.x).get(0) - push).norm() < 1e-12);
}

TEST_CASE("vertices that start inside a collider that pins are pinned to its motion") {
  Scenery s(Strands({4}, {{0, 0, 0}, {0, 0, 0.5}, {0, 0, 1.5}, {0, 0, 2.5}}, Material{}),
            R"({"type": "fcl", "colliders": [
               {"type": "sphere", "radius": 1, "motion": "nod", "pins": true},
               {"type": "sphere", "radius": 2}]})");
  add_nod(s.motions);
  s.start();
  const auto pins = s.stage->pins(rest_positions(s.strands));
  REQUIRE(pins.size() == 2);
  for (int n = 0; n < 2; ++n) {
    CHECK(pins[n].vertex == n);
    CHECK(pins[n].motion == "nod");
  }
}

TEST_CASE("pinned vertices do not feel colliders") {
  Scenery s(Strands({2}, {{0, 0, 0.5}, {0, 0, 2}}, Material{}),
            R"({"type": "fcl", "colliders": [{"type": "sphere", "radius": 1}]})");
  const auto [row, lane] = s.groups.slot(0);
  s.free[row][lane] = 0;
  s.start();
  CHECK(s.stage->add(s.x, nullptr) == 0);
}

TEST_CASE("candidates are kept for a step if detection is once a step") {
  for (const bool once : {true, false}) {
    Scenery s(Strands({2, 2}, {{-1, 0, 0}, {1, 0, 0}, {0, -1, 1}, {0, 1, 1}}, Material{}),
              std::string(R"({"type": "fcl", "thickness": 0.1, "detect": ")") +
                  (once ? "step" : "iteration") + "\"}");
    s.start();
    for (const int v : {2, 3}) s.x.add(v, {0, 0, -0.95});
    s.stage->detect(s.x);
    CHECK((s.stage->add(s.x, nullptr) == 0) == once);
    s.stage->begin_step(s.x, 0.01, 0.01);
    s.stage->detect(s.x);
    CHECK(s.stage->add(s.x, nullptr) > 0);
  }
}

TEST_CASE("candidates kept for as long as their margin allows miss no contact") {
  const bool strands_touch = GENERATE(true, false), all_drift = GENERATE(true, false);
  const std::string against = strands_touch ? R"("colliders": [])" : R"("strand_contacts": false,
      "colliders": [{"type": "sphere", "radius": 0.01, "motion": "nod"}])";
  std::mt19937 random(43);
  const Strands strands = random_bundle(random, 60);
  const auto scenery = [&](const std::string& detect) {
    auto made =
        std::make_unique<Scenery>(strands, R"({"type": "fcl", "thickness": 2e-3, "detect": ")" +
                                               detect + "\", " + against + "}");
    add_nod(made->motions);
    made->start();
    return made;
  };
  const auto always = scenery("iteration"), seldom = scenery("margin");
  Points drift(strands.count());
  for (auto& d : drift) d = random_point(random, 2e-4);
  if (!all_drift) {
    for (int s = 2; s < strands.count(); ++s) drift[s].setZero();
    for (int s = 0; s < 2; ++s) drift[s] *= 25;
  }
  const double tremble = all_drift ? 1e-4 : 1e-6;
  double most_energy = 0;
  for (int step = 1; step <= 30; ++step) {
    // All turn with the collider; besides, each strand drifts, or two dart to and fro, and
    // each vertex trembles.
    const Eigen::Isometry3d nod = Nod().at(0.05 * step) * Nod().at(0.05 * (step - 1)).inverse();
    const double way = all_drift || step % 6 < 3 ? 1 : -1;
    for (int v = 0; v < strands.vertex_count(); ++v) {
      const Eigen::Vector3d p = nod * always->x.get(v) + way * drift[strands.strand_of(v)] +
                                random_point(random, tremble);
      always->x.set(v, p);
      seldom->x.set(v, p);
    }
    for (Scenery* s : {always.get(), seldom.get()}) {
      s->stage->begin_step(s->x, 0.05 * step, 0.05);
      s->stage->add(s->x, nullptr);  // as a line search does, with the old candidates
      s->stage->detect(s->x);
    }
    const double energy = always->stage->add(always->x, nullptr);
    CHECK(seldom->stage->add(seldom->x, nullptr) == energy);
    most_energy = std::max(most_energy, energy);
  }
  CHECK(most_energy > 0);
}

TEST_CASE("one thread and two find the same contacts, to the last bit") {
  const auto run = [](int threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    std::mt19937 random(37);
    Scenery s(random_bundle(random, 200), bundle_stage);
    s.start();
    SystemMatrix matrix(s.groups);
    VertexField gradient(s.groups);
    const double energy = s.stage->add(s.x, &matrix.couplings);
    matrix.couplings.finish(s.free);
    for (int g = 0; g < s.groups.count(); ++g) {
      matrix.couplings.add_gradient(g, gradient.group(g));
    }
    std::vector<double> bits{energy};
    const Eigen::Matrix3Xd forces = gradient.matrix();
    bits.insert(bits.end(), forces.data(), forces.data() + forces.size());
    matrix.couplings.for_each_off_band([&](int row, int column, const Eigen::Matrix3d& block) {
      bits.insert(bits.end(), {double(row), double(column)});
      bits.insert(bits.end(), block.data(), block.data() + 9);
    });
    return bits;
  };
  const auto one = run(1), two = run(2);
  CHECK(one.size() > 1000);
  CHECK(one == two);
}

TEST_CASE("wrong parameters of the stage are refused with their pointers") {
  const auto problems_of = [](const char* json) {
    try {
      make_plugin<CollisionStage>(Json::parse(json));
    } catch (const InvalidInput& error) {
      return error.problems();
    }
    return std::vector<Problem>();
  };
  const auto problems = problems_of(R"({"type": "fcl", "thickness": 0, "stifness": 1, "colliders": [
    {"type": "plane", "normal": [0, 0, 0]}, {"type": "sphere"}, {"type": "sphre"}]})");
  std::vector<std::string> pointers;
  for (const Problem& problem : problems) pointers.push_back(problem.pointer);
  std::sort(pointers.begin(), pointers.end());
  CHECK(pointers == std::vector<std::string>{
                        "/plugin/colliders/0/normal", "/plugin/colliders/1/radius",
                        "/plugin/colliders/2/type", "/plugin/stifness", "/plugin/thickness"});
}
