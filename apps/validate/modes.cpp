// Small vibrations in a single mode, with the second-order integrator.

#include <array>
#include <cmath>

#include "apps/validate/statics.h"

namespace ringlet {
namespace {

constexpr double beam_length = 1;   // of the free part, m
constexpr double amplitude = 1e-4;  // of the tip, m
constexpr int steps_a_period = 240;
constexpr double periods = 3.3;

/// From the times at which the tip passes through its rest position.
double measure_frequency(Simulation& simulation, int direction) {
  const int tip = simulation.model().strands.vertex_count() - 1;
  const auto height = [&] { return simulation.state().positions.get(tip)[direction]; };
  const double rest = simulation.model().strands.rest_position(tip)[direction];
  std::vector<double> passages;
  double before = height() - rest;
  for (int step = 0; step < static_cast<int>(periods * steps_a_period); ++step) {
    const double time = simulation.state().time;
    const StepReport report = simulation.step();
    if (!report.failure.empty()) throw Error(report.failure);
    const double now = height() - rest;
    if ((before > 0) != (now > 0)) {
      const double part = before / (before - now);
      passages.push_back(time + part * (simulation.state().time - time));
    }
    before = now;
  }
  if (passages.size() < 3) throw Error("the strand does not swing");
  const double half_periods = static_cast<double>(passages.size() - 1);
  return pi * half_periods / (passages.back() - passages.front());
}

/// The scene, displaced sideways by shape(s) of the tip's amplitude, s from 0 at the clamp to 1.
template <class Shape>
double frequency_of(Json scene, int clamp, int direction, double omega, const Registry& registry,
                    const Shape& shape) {
  scene["integrator"]["dt"] = 2 * pi / omega / steps_a_period;
  const Simulation at_rest(read_scene(scene, registry, "."));
  const Strands& strands = at_rest.model().strands;
  Json positions = Json::array();
  const int edges = strands.vertex_count() - 1 - clamp;
  for (int v = 0; v < strands.vertex_count(); ++v) {
    Eigen::Vector3d x = strands.rest_position(v);
    const double s = std::max(0.0, static_cast<double>(v - clamp) / edges);
    x[direction] += amplitude * shape(s) / shape(1.0);
    positions.push_back({x.x(), x.y(), x.z()});
  }
  scene["start"] = {{{"type", "positions"}, {"strands", {positions}}}};
  Simulation simulation(read_scene(scene, registry, "."));
  return measure_frequency(simulation, direction);
}

}  // namespace

void validate_cantilever_modes(const Registry& registry, const ValidationOptions& options,
                               const ValidationOutput& output) {
  const Json scene = [] {
    Json made = validation_scene("vibrating_cantilever");
    set_clamped_edges(made, 100, beam_length);
    return made;
  }();
  const double radius = scene["material"]["radius"], density = scene["material"]["density"];
  const double modulus = scene["material"]["youngs_modulus"];
  // sqrt(B / (rho A L^4)) with B / A = E r^2 / 4
  const double unit =
      std::sqrt(modulus * radius * radius / (4 * density)) / (beam_length * beam_length);
  constexpr std::array squares{3.516015, 22.034492, 61.697214};
  for (std::size_t mode = 0; mode < squares.size(); ++mode) {
    if (options.quick && mode > 0) continue;
    const double beta = std::sqrt(squares[mode]);
    const double sigma = (std::cosh(beta) + std::cos(beta)) / (std::sinh(beta) + std::sin(beta));
    const auto shape = [&](double s) {
      const double b = beta * s;
      return std::cosh(b) - std::cos(b) - sigma * (std::sinh(b) - std::sin(b));
    };
    const double omega = squares[mode] * unit;
    output({"cantilever_modes", "omega_" + std::to_string(mode + 1) + ", rad/s", omega,
            frequency_of(scene, 1, 1, omega, registry, shape), 0.01});
  }
}

void validate_chain_modes(const Registry& registry, const ValidationOptions& options,
                          const ValidationOutput& output) {
  const Json scene = validation_scene("swinging_chain");
  const double unit = std::sqrt(9.81 / beam_length);
  constexpr std::array numbers{1.202413, 2.760039, 4.326864};
  for (std::size_t mode = 0; mode < numbers.size(); ++mode) {
    if (options.quick && mode > 0) continue;
    const auto shape = [&](double s) {
      return std::cyl_bessel_j(0, 2 * numbers[mode] * std::sqrt(1 - s));
    };
    const double omega = numbers[mode] * unit;
    output({"chain_modes", "omega_" + std::to_string(mode + 1) + ", rad/s", omega,
            frequency_of(scene, 0, 0, omega, registry, shape), 0.01});
  }
}

}  // namespace ringlet
