#pragma once

#include "apps/convert/input_frames.h"
#include "core/observer.h"
#include "core/simulation.h"

namespace ringlet {

/// Strands that are only there to be written: nothing acts on them.
std::unique_ptr<Model> model_of(const InputFrames& frames, const Registry& registry);

/// Throws Error if a model is not of the strands of the frames.
void require_same_strands(const InputFrames& frames, const Strands& strands);

/// Calls a writer with all frames, as a run would have done. The model has their strands.
/// Velocities are those from one frame to the next, and at first those of `state`; reports of steps
/// are empty.
void write_again(const InputFrames& frames, const Model& model, State state, Observer& writer,
                 const std::filesystem::path& folder);

}  // namespace ringlet
