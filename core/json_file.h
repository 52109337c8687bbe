#pragma once

#include <filesystem>

#include "core/parameters.h"

namespace ringlet {

/// Parses a JSON file; // and /* */ comments are allowed. Throws Error with line and column.
Json load_json(const std::filesystem::path& path);
/// The same; null where there is no such file.
Json load_json_if_there(const std::filesystem::path& path);

/// Writes a file as a whole. Throws Error if it cannot.
void write_json(const std::filesystem::path& path, const Json& json);

}  // namespace ringlet
