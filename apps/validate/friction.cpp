// Coulomb's friction on colliders.

#include <algorithm>
#include <cmath>

#include "apps/validate/statics.h"

namespace ringlet {
namespace {

// A body on a slope sticks where tan(alpha) <= mu, else it slides with the acceleration
// g (sin(alpha) - mu cos(alpha)).

struct Sliding {
  double speed;         // at the end, m/s
  double acceleration;  // of the time after it has come to lie or to slide, m/s^2
};

Sliding slide(double alpha, const Registry& registry) {
  constexpr double g = 9.81;
  constexpr int begin = 100, end = 400;
  Json scene = validation_scene("incline");
  scene["forces"][0]["acceleration"] = {g * std::sin(alpha), -g * std::cos(alpha), 0};
  const auto speed_after = [&](int steps) {
    scene["run"]["steps"] = steps;
    return run_scene(scene, registry)->state().velocities.get(0).x();
  };
  const double dt = scene["integrator"]["dt"];
  const double speed = speed_after(end);
  return {speed, (speed - speed_after(begin)) / ((end - begin) * dt)};
}

// Around a cylinder a rope that slides has tensions in the ratio exp(mu phi).

constexpr double cylinder = 0.0204;  // where the rope lies on it, m
constexpr double tail = 0.06;        // free ends, m
constexpr double edge = 1e-3;        // m

/// From the end that is drawn, by an angle around the cylinder, to the other one.
Json rope_around(double angle) {
  Json points = Json::array();
  const double arc = cylinder * angle;
  for (double s = -4 * edge; s < arc + tail; s += edge) {
    const double at = std::clamp(s / cylinder, 0.0, angle), straight = s - at * cylinder;
    points.push_back({cylinder * std::cos(at) - straight * std::sin(at),
                      cylinder * std::sin(at) + straight * std::cos(at), 0});
  }
  return points;
}

/// The mean ratio of the tensions at both ends while the rope slides.
double ratio_of_tensions(double angle, const Registry& registry) {
  Json scene = validation_scene("capstan");
  scene["strands"]["strands"] = {rope_around(angle)};
  const double load = 4e-4;  // N
  scene["forces"][0]["force"] = {-load * std::sin(angle), load * std::cos(angle), 0};
  const double radius = scene["material"]["radius"], modulus = scene["material"]["youngs_modulus"];

  const Scene read = read_scene(scene, registry, ".");
  Simulation simulation(read);
  const int settling = read.run.steps / 2;
  double sum = 0;
  for (int step = 0; step < read.run.steps; ++step) {
    const StepReport report = simulation.step();
    if (!report.failure.empty()) throw Error(report.failure);
    if (step < settling) continue;
    const VertexField& x = simulation.state().positions;
    const double length = (x.get(1) - x.get(0)).norm();
    const double strain = length / simulation.model().strands.rest_length(0) - 1;
    sum += modulus * pi * radius * radius * strain / load;
  }
  return sum / (read.run.steps - settling);
}

}  // namespace

void validate_incline(const Registry& registry, const ValidationOptions&,
                      const ValidationOutput& output) {
  const double mu = validation_scene("incline")["collision"]["collider_friction"];
  // What sticks creeps with less than the sticking speed.
  output({"incline", "speed at 0.97 of the friction, m/s", 0,
          slide(std::atan(0.97 * mu), registry).speed, 1e-3});
  for (const double steepness : {1.1, 2.0}) {
    const double alpha = std::atan(steepness * mu);
    output({"incline", "acceleration at tan(alpha) = " + Json(steepness).dump() + " mu, m/s^2",
            9.81 * (std::sin(alpha) - mu * std::cos(alpha)), slide(alpha, registry).acceleration,
            0.03});
  }
}

void validate_capstan(const Registry& registry, const ValidationOptions& options,
                      const ValidationOutput& output) {
  const double mu = validation_scene("capstan")["collision"]["collider_friction"];
  for (const double turns : {0.5, 1.0}) {
    if (options.quick && turns == 1) continue;
    const double angle = 2 * pi * turns;
    output({"capstan", "ratio of the tensions, " + Json(turns).dump() + " turns",
            std::exp(mu * angle), ratio_of_tensions(angle, registry), 0.03});
  }
}

}  // namespace ringlet
