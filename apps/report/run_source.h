#pragma once

#include <filesystem>
#include <string>

#include "core/json_file.h"

namespace ringlet {

/// scene.resolved.json of a run folder. Throws Error if the folder is none.
Json load_scene_of_run(const std::filesystem::path& folder);

/// summary.json of a run folder; null while the run goes on, and if it was killed.
Json load_summary_of_run(const std::filesystem::path& folder);

/// What the scene of the run is called, or, where there is no summary, the folder.
std::string name_of_run(const std::filesystem::path& folder);

}  // namespace ringlet
