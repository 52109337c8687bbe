#include "apps/overrides.h"

#include <algorithm>
#include <vector>

namespace ringlet {
namespace {

std::string unescape(const std::string& token) {
  std::string text;
  for (std::size_t i = 0; i < token.size(); ++i) {
    if (token[i] != '~') {
      text += token[i];
    } else if (i + 1 < token.size() && (token[i + 1] == '0' || token[i + 1] == '1')) {
      text += token[++i] == '0' ? '~' : '/';
    } else {
      throw Error("'~' must be followed by 0 or 1 in a JSON pointer");
    }
  }
  return text;
}

std::vector<std::string> split_pointer(const std::string& pointer) {
  if (pointer.empty() || pointer[0] != '/') throw Error("a JSON pointer begins with '/'");
  std::vector<std::string> tokens;
  for (std::size_t begin = 1; begin <= pointer.size();) {
    const std::size_t end = std::min(pointer.find('/', begin), pointer.size());
    tokens.push_back(unescape(pointer.substr(begin, end - begin)));
    begin = end + 1;
  }
  return tokens;
}

Json& entry_of_list(Json& list, const std::string& token) {
  const bool is_number =
      !token.empty() && token.size() < 9 &&
      std::all_of(token.begin(), token.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
  if (!is_number || std::stoul(token) >= list.size()) {
    throw Error("'" + token + "' is no entry of a list of " + std::to_string(list.size()));
  }
  return list[std::stoul(token)];
}

Json& entry_of(Json& json, const std::string& token) {
  if (json.is_array()) return entry_of_list(json, token);
  if (!json.is_null() && !json.is_object()) {
    throw Error("'" + token + "' cannot be an entry of " + json.dump() +
                ", which is no object or list");
  }
  return json[token];
}

}  // namespace

void set_entry(Json& scene, const std::string& pointer, const Json& value) {
  Json* entry = &scene;
  for (const std::string& token : split_pointer(pointer)) entry = &entry_of(*entry, token);
  *entry = value;
}

void apply_override(Json& scene, const std::string& assignment) {
  try {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos) throw Error("expected /pointer=value");
    const std::string text = assignment.substr(equals + 1);
    const Json value = Json::parse(text, nullptr, false);
    set_entry(scene, assignment.substr(0, equals), value.is_discarded() ? Json(text) : value);
  } catch (const Error& error) {
    throw Error("--set '" + assignment + "': " + error.what());
  }
}

}  // namespace ringlet
