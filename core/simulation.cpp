#include "core/simulation.h"

#include <map>

#include "core/checkpoint.h"
#include "core/error.h"
#include "core/pose.h"
#include "core/rest_state.h"
#include "core/strand_source.h"

namespace ringlet {
namespace {

StrandSet generate_all(const std::vector<Choice<StrandSource>>& sources) {
  StrandSet all;
  const auto append = [](auto& to, const auto& from) {
    to.insert(to.end(), from.begin(), from.end());
  };
  for (const auto& source : sources) {
    const auto made = source.make();
    const StrandSet set = naming(*made, [&] { return made->generate(); });
    append(all.vertex_counts, set.vertex_counts);
    append(all.positions, set.positions);
    append(all.pinned_counts, set.pinned_counts);
    append(all.motions, set.motions);
  }
  if (all.vertex_counts.empty()) throw Error("the scene's strand sources made no strand");
  return all;
}

// A vertex held by its strand and also inside a collider that pins follows the strand's motion if
// the scene names one, else the collider's.
std::vector<Pin> collect_pins(const Strands& strands, const StrandSet& set,
                              const std::vector<Pin>& collider_pins) {
  std::map<int, std::string> motion_of;
  for (const Pin& pin : collider_pins) motion_of[pin.vertex] = pin.motion;
  for (int strand = 0; strand < strands.count(); ++strand) {
    for (int i = 0; i < std::min(set.pinned_counts[strand], strands.size(strand)); ++i) {
      const auto [entry, is_new] =
          motion_of.try_emplace(strands.first(strand) + i, set.motions[strand]);
      if (!is_new && !set.motions[strand].empty()) entry->second = set.motions[strand];
    }
  }
  std::vector<Pin> pins;
  for (const auto& [vertex, motion] : motion_of) pins.push_back({vertex, motion});
  return pins;
}

/// Those that vanish are left out.
template <class Interface>
std::vector<std::unique_ptr<Interface>> make_terms(const std::vector<Choice<Interface>>& choices,
                                                   Model& model) {
  std::vector<std::unique_ptr<Interface>> terms;
  for (const auto& choice : choices) {
    std::unique_ptr<Interface> term = choice.make();
    const bool vanishes = naming(*term, [&] {
      term->bind(model.strands, model.groups);
      return term->vanishes();
    });
    if (vanishes) {
      model.left_out.push_back({Kind<Interface>::name, term->name()});
    } else {
      terms.push_back(std::move(term));
    }
  }
  return terms;
}

/// Of each strand, whether all of its vertices are pinned.
std::vector<bool> held_strands(const StrandSet& set) {
  std::vector<bool> held(set.vertex_counts.size());
  for (std::size_t i = 0; i < held.size(); ++i) {
    held[i] = set.pinned_counts[i] >= set.vertex_counts[i];
  }
  return held;
}

}  // namespace

Simulation::Simulation(const Scene& scene) {
  StrandSet set = generate_all(scene.strands);
  model_ = std::make_unique<Model>(
      Strands(set.vertex_counts, set.positions, scene.material, set.pinned_counts),
      held_strands(set));
  Model& model = *model_;
  for (const auto& [name, parts] : scene.motions) {
    std::vector<std::unique_ptr<Motion>> made;
    for (const auto& part : parts) made.push_back(part.make());
    model.motions.add(name, std::move(made));
  }
  for (const auto& choice : scene.start) {
    const auto pose = choice.make();
    naming(*pose, [&] { pose->apply(model.strands, set.pinned_counts, set.positions); });
  }

  std::vector<Pin> collider_pins;
  if (scene.collision) {
    model.collision = scene.collision->make();
    collider_pins = naming(*model.collision, [&] {
      model.collision->bind(model.strands, model.groups, model.motions);
      return model.collision->pins(set.positions);
    });
  }
  model.set_pins(collect_pins(model.strands, set, collider_pins), set.positions);
  if (model.collision) model.collision->set_free(model.free);

  model.energies = make_terms(scene.energies, model);
  model.couplings = make_terms(scene.couplings, model);
  model.forces = make_terms(scene.forces, model);
  if (scene.rest) {
    const auto rest = scene.rest->make();
    model.rest = naming(*rest, [&] { return rest->choose(model); });
  }
  model.solver = scene.solver.make();
  naming(*model.solver, [&] { model.solver->bind(model.groups); });

  state_.positions = positions_with_pads(model.groups, set.positions);
  state_.velocities = VertexField(model.groups);
  integrator_ = scene.integrator.make();
  naming(*integrator_, [&] { integrator_->bind(model); });
}

void Simulation::set_state(const State& state) {
  state_.time = state.time;
  state_.positions.set_matrix(state.positions.matrix());
  state_.velocities.set_matrix(state.velocities.matrix());
  state_.history.dt = 0;
  state_.history.still_steps.clear();
}

std::string Simulation::checkpoint() const {
  return write_checkpoint(*model_, state_, steps_done_);
}

void Simulation::go_on_from(std::string_view checkpoint) {
  steps_done_ = read_checkpoint(checkpoint, *model_, state_);
}

StepReport Simulation::step() {
  StepReport report;
  try {
    report = naming(*integrator_,
                    [&] { return integrator_->step(*model_, state_, integrator_->time_step()); });
  } catch (const PluginError& error) {
    report.failure = error.what();
  }
  if (report.failure.empty()) ++steps_done_;
  return report;
}

void place_pins(const Model& model, double time, VertexField& x) {
  Displacements since_start(model.motions, 0, time);
  for (const PlacedPin& pin : model.pins) {
    x.set(pin.vertex, since_start.by(pin.motion) * pin.start);
  }
}

}  // namespace ringlet
