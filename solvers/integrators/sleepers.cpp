#include "solvers/integrators/sleepers.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/parallel.h"

namespace ringlet {
namespace {

double fastest(std::span<const Vector3<Pack>> velocities) {
  Pack largest = 0;
  for (const Vector3<Pack>& v : velocities) largest = max(largest, squared_norm(v));
  return std::sqrt(std::experimental::hmax(largest));
}

bool moves(std::span<const Vector3<Pack>> from, std::span<const Vector3<Pack>> to) {
  Pack largest = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    largest = max(largest, squared_norm(to[i] - from[i]));
  }
  return std::experimental::hmax(largest) > 0;
}

}  // namespace

void Sleepers::bind(const Model& model) {
  if (!are_wanted()) return;
  free_when_awake_ = model.free;
  is_held_.assign(model.groups.count(), 0);
}

void Sleepers::hold(Model& model, const State& state, const VertexField& guess) {
  if (!are_wanted()) return;
  for (int g = 0; g < model.groups.count(); ++g) {
    const bool is_asleep = !state.history.still_steps.empty() && sleeps(state.history, g) &&
                           !moves(state.positions.group(g), guess.group(g));
    if (is_asleep == (is_held_[g] != 0)) continue;
    is_held_[g] = is_asleep ? 1 : 0;
    const auto [first, vertices, strands] = model.groups[g];
    for (int row = first; row < first + vertices; ++row) {
      model.free[row] = is_asleep ? Pack(0) : free_when_awake_[row];
    }
  }
}

void Sleepers::look(const Model& model, State& state, double dt, const Couplings& couplings) {
  if (!are_wanted()) return;
  auto& still = state.history.still_steps;
  still.resize(model.groups.count(), 0);
  parallel_for_each(model.groups.count(), [&](int g) {
    if (holds(g)) {
      ++still[g];
      const bool is_looked_at = still[g] % parameters_.sleep_steps == 0;
      if (is_looked_at && is_pushed(model, state, g, dt, couplings)) still[g] = 0;
    } else {
      const bool is_still =
          fastest(std::as_const(state.velocities).group(g)) < parameters_.sleep_speed;
      still[g] = is_still ? still[g] + 1 : 0;
    }
  });
}

bool Sleepers::is_pushed(const Model& model, const State& state, int group, double dt,
                         const Couplings& couplings) const {
  const auto x = state.positions.group(group);
  std::vector<Vector3<Pack>> gradient(x.size(), {0, 0, 0});
  for (const auto& energy : model.energies) add_at_vertices(*energy, group, x, {gradient, {}});
  for (const auto& force : model.forces) force->add(group, x, {gradient, {}});
  couplings.add_gradient(group, gradient);
  const int first = model.groups[group].first_row;
  Pack largest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Pack gain = free_when_awake_[first + i] * dt / model.mass[first + i];
    largest = max(largest, gain * gain * squared_norm(gradient[i]));
  }
  return std::sqrt(std::experimental::hmax(largest)) > parameters_.sleep_speed;
}

}  // namespace ringlet
