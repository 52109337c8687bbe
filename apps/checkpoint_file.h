#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace ringlet {

/// checkpoint.bin of a run folder: the first words, a checkpoint of the simulation, and the CRC-32
/// of both. It is replaced as a whole, so that there is one however the run ends.
void write_checkpoint_file(const std::filesystem::path& folder, const std::string& checkpoint);

/// The checkpoint; nothing if the run wrote none. Throws Error if the file is damaged.
std::optional<std::string> read_checkpoint_file(const std::filesystem::path& folder);

}  // namespace ringlet
