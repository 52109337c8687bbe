#include "apps/run_folder.h"

#include "core/error.h"

namespace ringlet {
namespace {

namespace fs = std::filesystem;

fs::path create_numbered(const fs::path& parent, const std::string& name) {
  fs::create_directories(parent);
  fs::path folder = parent / name;
  // create_directory() says who made the folder, so two runs that start together get one each.
  for (int number = 2; !fs::create_directory(folder); ++number) {
    folder = parent / (name + "_" + std::to_string(number));
  }
  return folder;
}

}  // namespace

fs::path create_empty_folder(const fs::path& folder) {
  if (fs::exists(folder) && (!fs::is_directory(folder) || !fs::is_empty(folder))) {
    throw Error("'" + folder.string() +
                "' exists and is not an empty folder; name another one or remove it");
  }
  try {
    fs::create_directories(folder);
  } catch (const fs::filesystem_error& error) {
    throw Error(std::string("cannot create a folder: ") + error.what());
  }
  return folder;
}

fs::path create_run_folder(const std::optional<std::string>& wanted,
                           const std::string& scene_name) {
  try {
    return wanted ? create_empty_folder(*wanted) : create_numbered("results", scene_name);
  } catch (const fs::filesystem_error& error) {
    throw Error(std::string("cannot create the folder of the results: ") + error.what());
  }
}

}  // namespace ringlet
