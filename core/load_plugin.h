#pragma once

#include <filesystem>
#include <string>

#include "core/registry.h"

namespace ringlet {

/// Loads a plugin library, which a RINGLET_PLUGIN made one, and adds what it offers to the
/// registry. `plugin` is the path of the library, relative to the folder, or, without a slash, the
/// name NAME of a file NAME.so in a folder of the environment variable RINGLET_PLUGIN_PATH, where
/// colons part them. A library is loaded once, and stays until the program ends: whatever it made
/// needs its code.
///
/// Throws Error where there is no such file, it is no library or misses symbols, it is no plugin,
/// was built against another ringlet, compiler, processor or alignment, or offers a name that is
/// taken; the registry is then as it was.
void load_plugin(const std::string& plugin, const std::filesystem::path& folder,
                 Registry& registry);

/// The file that a path means; a name stays what it is.
std::string plugin_file(const std::string& plugin, const std::filesystem::path& folder);

/// Loads what the entry "plugins" of a scene names, before the scene is read. What is wrong with
/// the entry itself, read_scene() will tell. Throws InvalidInput.
void load_plugins_of(const Json& scene, const std::filesystem::path& folder, Registry& registry);

}  // namespace ringlet
