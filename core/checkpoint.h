#pragma once

#include <string>
#include <string_view>

#include "core/model.h"
#include "core/state.h"

namespace ringlet {

/// All that the steps to come depend on besides the scene, as bytes: the state with its history,
/// what terms change when a step begins, and the number of steps done. Whoever goes on from it goes
/// on as if nothing had been between, to the bit.
std::string write_checkpoint(Model& model, const State& state, int steps_done);

/// Brings a model of the same scene, and its state, to a checkpoint; returns the number of steps
/// done there. Throws Error, and changes nothing, if it is of another scene, version, compiler or
/// kind of processor, or is not whole.
int read_checkpoint(std::string_view bytes, Model& model, State& state);

}  // namespace ringlet
