#include <Eigen/Geometry>

#include "solvers/integrators/first_guess.h"
#include "tests/catch.h"
#include "tests/solvers/test_model.h"

using namespace ringlet;

namespace {

/// Turns about the z axis by t rad, and rises by 2 t m.
class Screw final : public Motion {
 public:
  Eigen::Isometry3d at(double time) const override {
    return Eigen::Translation3d(0, 0, 2 * time) *
           Eigen::Isometry3d(Eigen::AngleAxisd(time, Eigen::Vector3d::UnitZ()));
  }
};

/// Three strands: the pin of the second one follows the motion, that of the third stays.
std::unique_ptr<Model> make_turning_model() {
  auto model = make_model({4, 5, 6}, true);
  std::vector<std::unique_ptr<Motion>> parts;
  parts.push_back(std::make_unique<Screw>());
  model->motions.add("screw", std::move(parts));
  model->pins.erase(model->pins.begin());
  model->pins.front().motion = "screw";
  return model;
}

}  // namespace

TEST_CASE("a first guess carries strands along with their pins") {
  const auto model = make_turning_model();
  const State state = rest_state(*model);
  VertexField x(model->groups);
  carry_strands_with_pins(*model, state.positions, 0, 0.5, x);
  const Eigen::Isometry3d moved = Screw().at(0.5);
  for (int v = 0; v < model->strands.vertex_count(); ++v) {
    const Eigen::Vector3d start = state.positions.get(v);
    if (model->strands.strand_of(v) == 1) {
      CHECK(x.get(v).isApprox(moved * start, 1e-14));
    } else {
      CHECK(x.get(v) == start);
    }
  }
}

TEST_CASE("pins follow their motion without drift, however the strand moves") {
  const auto model = make_turning_model();
  add_energy(*model, std::make_unique<Springs>(0.5));
  const auto integrator = make_integrator({{"type", "bdf1"}, {"dt", 0.05}}, *model);
  State state = rest_state(*model);
  for (int n = 0; n < 40; ++n) {
    const State before = state;
    REQUIRE(integrator->step(*model, state, integrator->time_step()).failure.empty());
    for (const Pin& pin : model->pins) {
      const Eigen::Vector3d expected =
          model->motions.at(pin.motion, state.time) * model->strands.rest_position(pin.vertex);
      CHECK((state.positions.get(pin.vertex) - expected).norm() < 1e-13);
      const Eigen::Vector3d moved =
          state.positions.get(pin.vertex) - before.positions.get(pin.vertex);
      CHECK((state.velocities.get(pin.vertex) - moved / 0.05).norm() < 1e-12);
    }
  }
}
