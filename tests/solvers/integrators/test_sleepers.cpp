#include <algorithm>

#include "tests/catch.h"
#include "tests/solvers/integrators/lively.h"

using namespace ringlet;

namespace {

constexpr double step_length = 0.05, speed = 1e-3;

/// Springs that remember whether derivatives were wanted.
class Watched final : public Energy {
 public:
  explicit Watched(double stiffness) : springs_(stiffness) {}
  void bind(const Strands& strands, const StrandGroups& groups) override {
    springs_.bind(strands, groups);
  }
  double add(int group, std::span<const Vector3<Pack>> x, EdgeOutputs outputs) const override {
    if (!outputs.hessian.empty()) is_wanted = true;
    return springs_.add(group, x, outputs);
  }
  mutable bool is_wanted = false;

 private:
  Springs springs_;
};

/// Rests for two seconds, then rises.
struct Late final : Motion {
  Eigen::Isometry3d at(double time) const override {
    return Eigen::Isometry3d(Eigen::Translation3d(0, std::max(0.0, time - 4), 0));
  }
};

/// Strands that swing until a resistance has brought them to rest; a push can be turned on.
struct Swing {
  explicit Swing(double sleep_speed, const char* type = "bdf1") : model(make_model({4, 7}, true)) {
    std::vector<std::unique_ptr<Motion>> parts;
    parts.push_back(std::make_unique<Late>());
    model->motions.add("late", std::move(parts));
    for (Pin& pin : model->pins) pin.motion = "late";
    auto springs = std::make_unique<Watched>(200 * model->strands.mass(1));
    energy = springs.get();
    add_energy(*model, std::move(springs));
    add_force(*model, std::make_unique<Weight>(Eigen::Vector3d(0, -9.81, 0)));
    add_force(*model, std::make_unique<Resistance>(6));
    add_force(*model, std::make_unique<PointForce>([this](int vertex, const Eigen::Vector3d& x) {
      const Eigen::Vector3d f(push * model->strands.mass(vertex), 0, 0);
      return PointValue{-f.dot(x), -f, Eigen::Matrix3d::Zero()};
    }));
    integrator = make_integrator({{"type", type},
                                  {"sleep_speed", sleep_speed},
                                  {"sleep_steps", 5},
                                  {"newton_tolerance", 1e-9}},
                                 *model);
    state = thrown_state(*model);
  }
  void go(int steps) {
    for (int n = 0; n < steps; ++n) {
      energy->is_wanted = false;
      REQUIRE(integrator->step(*model, state, step_length).failure.empty());
    }
  }
  double distance_to(const Swing& other) const {
    return (state.positions.matrix() - other.state.positions.matrix()).colwise().norm().maxCoeff();
  }

  std::unique_ptr<Model> model;
  Watched* energy = nullptr;
  double push = 0;
  std::unique_ptr<Integrator> integrator;
  State state;
};

}  // namespace

TEST_CASE("strands that have come to rest are not solved, near where they would have rested") {
  for (const char* type : {"bdf1", "bdf2", "newmark"}) {
    CAPTURE(type);
    Swing asleep(speed, type), awake(0, type);
    asleep.go(75);
    awake.go(75);
    CHECK_FALSE(asleep.energy->is_wanted);
    CHECK(awake.energy->is_wanted);
    CHECK(asleep.state.velocities.matrix().isZero(0));
    // Creeping ends at a speed that decays within a second.
    CHECK(asleep.distance_to(awake) < speed);
    CHECK(asleep.distance_to(awake) > 0);
  }
}

TEST_CASE("sleepers wake as their pins move") {
  Swing asleep(speed), awake(0);
  asleep.go(75);
  awake.go(75);
  REQUIRE_FALSE(asleep.energy->is_wanted);
  asleep.go(20);
  awake.go(20);
  CHECK(asleep.energy->is_wanted);
  CHECK(asleep.state.velocities.get(3).y() > 0.5);
  CHECK(asleep.distance_to(awake) < 2 * speed);
}

TEST_CASE("sleepers wake as they are pushed, within the steps between two looks") {
  Swing asleep(speed);
  asleep.go(75);
  REQUIRE_FALSE(asleep.energy->is_wanted);
  const double x = asleep.state.positions.get(3).x();
  asleep.push = 1e-2;  // m/s^2: too little in a step
  asleep.go(5);
  CHECK_FALSE(asleep.energy->is_wanted);
  CHECK(asleep.state.positions.get(3).x() == x);
  asleep.push = 1;
  asleep.go(6);
  CHECK(asleep.energy->is_wanted);
  CHECK(asleep.state.positions.get(3).x() > x);
}

TEST_CASE("who sleeps is part of the state") {
  Swing first(speed), second(speed);
  first.go(72);
  second.state = first.state;
  for (VertexField* field : {&second.state.positions, &second.state.velocities}) {
    VertexField own(second.model->groups);
    own.set_matrix(field->matrix());
    *field = own;
  }
  second.state.positions = rest_state(*second.model).positions;
  second.state.positions.set_matrix(first.state.positions.matrix());
  first.go(12);
  second.go(12);
  CHECK(first.state.history.still_steps == second.state.history.still_steps);
  CHECK(first.state.positions.matrix() == second.state.positions.matrix());
}
