#pragma once

#include <filesystem>

#include "apps/arguments.h"
#include "core/scene.h"

namespace ringlet {

/// The options of every command that reads a scene.
std::vector<Option> scene_options();

/// Reads the scene that the first operand names, changed as those options ask. Throws Error.
Scene read_scene_argument(Registry& registry, const Arguments& arguments);

/// The scene of a run folder, with the steps that those options ask for. Throws Error.
Scene read_scene_of_run(const std::filesystem::path& folder, Registry& registry,
                        const Arguments& arguments);

}  // namespace ringlet
