#include "core/module_costs.h"

#include "core/registry.h"

namespace ringlet {

std::vector<ModuleCost> list_costs(const Simulation& simulation) {
  const Model& model = simulation.model();
  const std::size_t in_model = model.strands.bytes() + model.groups.bytes() + bytes_of(model.free) +
                               bytes_of(model.has_pins) + bytes_of(model.mass) +
                               bytes_of(model.pins);
  std::vector<ModuleCost> costs{{"strands", "", 0, in_model},
                                {"state", "", 0, simulation.state().bytes()}};
  const auto add_all = [&](const auto& terms) {
    for (const auto& term : terms) costs.push_back(cost_of(*term));
  };
  add_all(model.energies);
  add_all(model.couplings);
  add_all(model.forces);
  if (model.collision) costs.push_back(cost_of(*model.collision));
  costs.push_back(cost_of(*model.solver));
  costs.push_back(cost_of(simulation.integrator()));
  for (const LeftOut& term : model.left_out) {
    costs.push_back({.kind = term.kind, .name = term.name, .left_out = true});
  }
  return costs;
}

}  // namespace ringlet
