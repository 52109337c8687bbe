#pragma once

#include <filesystem>

namespace ringlet {

/// Cuts a text file after its first lines. Throws Error if it has fewer.
void keep_lines(const std::filesystem::path& file, int count);

}  // namespace ringlet
