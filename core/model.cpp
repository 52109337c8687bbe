#include "core/model.h"

#include "core/registry.h"
#include "core/vertex_scalars.h"

namespace ringlet {

Model::Model(Strands given, const std::vector<bool>& is_held)
    : strands(std::move(given)),
      groups(strands, is_held),
      mass(vertex_scalars(
          groups, [this](int vertex) { return strands.mass(vertex); }, 1)) {
  set_pins({}, {});
}

void Model::set_pins(std::span<const Pin> given, std::span<const Eigen::Vector3d> positions) {
  pins.clear();
  free = vertex_scalars(groups, [](int) { return 1.0; });
  has_pins.assign(groups.rows(), false);
  for (const Pin& pin : given) {
    pins.push_back({pin, positions[pin.vertex]});
    const auto [row, lane] = groups.slot(pin.vertex);
    free[row][lane] = 0;
    has_pins[row] = true;
  }
}

std::vector<std::string> energy_names(const Model& model) {
  std::vector<std::string> names;
  for (const auto& energy : model.energies) names.push_back(energy->name());
  for (const auto& coupling : model.couplings) names.push_back(coupling->name());
  return names;
}

std::vector<std::string> left_out_energy_names(const Model& model) {
  std::vector<std::string> names;
  for (const LeftOut& term : model.left_out) {
    if (term.kind != Kind<Force>::name) names.push_back(term.name);
  }
  return names;
}

void begin_step(Model& model, const State& state, double dt, const EndVelocity& velocity) {
  const StepStart start{state, dt, model.energies, velocity};
  const auto begin_all = [&](const auto& terms) {
    for (const auto& term : terms) naming(*term, [&] { term->begin_step(start); });
  };
  begin_all(model.energies);
  begin_all(model.couplings);
  begin_all(model.forces);
}

}  // namespace ringlet
