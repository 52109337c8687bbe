#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace ringlet {

/// Makes a folder, with those above it, unless it is there and empty. Throws Error.
std::filesystem::path create_empty_folder(const std::filesystem::path& folder);

/// Creates the folder of a run. No existing result is ever touched: a folder that is wanted by name
/// must be new or empty, else Error is thrown; the default, results/SCENE below the working folder,
/// goes on to SCENE_2, SCENE_3, ... until one is new.
std::filesystem::path create_run_folder(const std::optional<std::string>& wanted,
                                        const std::string& scene_name);

}  // namespace ringlet
