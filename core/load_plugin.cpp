#include "core/load_plugin.h"

#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "core/plugin.h"

namespace ringlet {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> search_path() {
  const char* variable = std::getenv("RINGLET_PLUGIN_PATH");
  std::istringstream folders(variable != nullptr ? variable : "");
  std::vector<fs::path> path;
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (!folder.empty()) path.emplace_back(folder);
  }
  return path;
}

fs::path find_named(const std::string& name) {
  std::string searched;
  for (const fs::path& folder : search_path()) {
    const fs::path file = folder / (name + ".so");
    if (fs::is_regular_file(file)) return fs::absolute(file);
    searched += (searched.empty() ? "" : ", ") + folder.string();
  }
  throw Error("there is no plugin '" + name + "' in a folder of RINGLET_PLUGIN_PATH (" +
              (searched.empty() ? "not set" : searched) + "); a path has a slash: './" + name +
              ".so'");
}

bool is_path(const std::string& plugin) { return plugin.find('/') != std::string::npos; }

fs::path find_library(const std::string& plugin, const fs::path& folder) {
  if (!is_path(plugin)) return find_named(plugin);
  const std::string file = plugin_file(plugin, folder);
  if (!fs::is_regular_file(file)) throw Error("there is no plugin '" + file + "'");
  return file;
}

void add_from(void* library, const fs::path& file, Registry& registry) {
  using Register = void (*)(Registry&);
  const auto* stamp = static_cast<const PluginStamp*>(dlsym(library, "ringlet_plugin_stamp"));
  const auto add = reinterpret_cast<Register>(dlsym(library, "ringlet_plugin_register"));
  if (stamp == nullptr || add == nullptr) {
    throw Error("it is no plugin: RINGLET_PLUGIN(...) of core/plugin.h is missing in it");
  }
  if (const std::string reason = difference(*stamp); !reason.empty()) throw Error(reason);
  Registry extended = registry;
  try {
    extended.add_library(file.string(), add);
  } catch (const std::exception& error) {
    throw Error(error.what());
  } catch (...) {
    throw Error("it throws something unknown as it registers");
  }
  registry = std::move(extended);
}

}  // namespace

std::string difference(const PluginStamp& stamp) {
  const auto differ = [](const std::string& what, const std::string& plugin,
                         const std::string& program) {
    return what + " " + plugin + ", this program with " + program + "; build it anew";
  };
  const std::string with = "it was built with ";
  if (std::string(stamp.version) != this_build.version) {
    return differ(with + "ringlet", stamp.version, this_build.version);
  }
  if (std::string(stamp.compiler) != this_build.compiler) {
    return differ(with + "the compiler", stamp.compiler, this_build.compiler);
  }
  if (stamp.lanes != this_build.lanes) {
    return differ(with + "packs of so many doubles:", std::to_string(stamp.lanes),
                  std::to_string(this_build.lanes));
  }
  if (stamp.eigen_alignment != this_build.eigen_alignment) {
    return differ(with + "EIGEN_MAX_ALIGN_BYTES", std::to_string(stamp.eigen_alignment),
                  std::to_string(this_build.eigen_alignment));
  }
  return "";
}

std::string plugin_file(const std::string& plugin, const fs::path& folder) {
  return is_path(plugin) ? fs::absolute(folder / plugin).lexically_normal().string() : plugin;
}

void load_plugin(const std::string& plugin, const fs::path& folder, Registry& registry) {
  const fs::path file = find_library(plugin, folder);
  const auto& loaded = registry.libraries();
  if (std::find(loaded.begin(), loaded.end(), file.string()) != loaded.end()) return;
  // All symbols at once: a missing one is told now and not in the middle of a run.
  void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw Error("cannot load the plugin: " + std::string(dlerror()));
  try {
    add_from(library, file, registry);
  } catch (const Error& error) {
    dlclose(library);
    throw Error("cannot use the plugin '" + file.string() + "': " + error.what());
  }
}

void load_plugins_of(const Json& scene, const fs::path& folder, Registry& registry) {
  if (!scene.is_object() || !scene.contains("plugins") || !scene["plugins"].is_array()) return;
  const Json& plugins = scene["plugins"];
  std::vector<Problem> problems;
  for (std::size_t i = 0; i < plugins.size(); ++i) {
    if (!plugins[i].is_string()) continue;
    try {
      load_plugin(plugins[i].get<std::string>(), folder, registry);
    } catch (const Error& error) {
      problems.push_back({pointer_to("/plugins", i), error.what()});
    }
  }
  if (!problems.empty()) throw InvalidInput(std::move(problems));
}

}  // namespace ringlet
