#include "core/json_file.h"

#include <fstream>
#include <set>

#include "core/atomic_file.h"
#include "core/error.h"

namespace ringlet {

Json load_json(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) throw Error("cannot open '" + path.string() + "'");
  std::vector<std::set<std::string>> keys_of_open_objects;
  std::vector<std::string> repeated;
  const auto watch = [&](int, Json::parse_event_t event, Json& parsed) {
    if (event == Json::parse_event_t::object_start) keys_of_open_objects.emplace_back();
    if (event == Json::parse_event_t::object_end) keys_of_open_objects.pop_back();
    if (event == Json::parse_event_t::key &&
        !keys_of_open_objects.back().insert(parsed.get<std::string>()).second) {
      repeated.push_back(parsed.get<std::string>());
    }
    return true;
  };
  try {
    Json json = Json::parse(file, watch, true, true);
    if (!repeated.empty()) {
      throw Error("'" + path.string() + "': the key '" + repeated.front() +
                  "' stands twice in one object");
    }
    return json;
  } catch (const Json::exception& error) {
    throw Error("'" + path.string() + "' is not valid JSON: " + error.what());
  }
}

Json load_json_if_there(const std::filesystem::path& path) {
  return std::filesystem::exists(path) ? load_json(path) : Json();
}

void write_json(const std::filesystem::path& path, const Json& json) {
  AtomicFile file(path);
  file.stream() << json.dump(2) << '\n';
  file.commit();
}

}  // namespace ringlet
