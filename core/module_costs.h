#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/simulation.h"

namespace ringlet {

/// What one part of a simulation has cost so far.
struct ModuleCost {
  std::string kind, name;
  double seconds = 0;     ///< of its calls, those of several threads added up; 0: not measured
  std::size_t bytes = 0;  ///< that it holds now; 0: nothing to speak of
  bool left_out = false;  ///< since it is zero wherever the strands are
};

/// Of all parts of a simulation, those that are left out last.
std::vector<ModuleCost> list_costs(const Simulation& simulation);

/// Of a plugin.
template <class Interface>
ModuleCost cost_of(const Interface& plugin) {
  return {Kind<Interface>::name, plugin.name(), plugin.work_time().seconds(), plugin.bytes()};
}

}  // namespace ringlet
