#include "core/parameters.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/suggest.h"

namespace ringlet {
namespace {

std::string format(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

}  // namespace

std::string pointer_to(const std::string& parent, const std::string& key) {
  std::string pointer = parent + "/";
  for (const char c : key) {
    if (c == '~') {
      pointer += "~0";
    } else if (c == '/') {
      pointer += "~1";
    } else {
      pointer += c;
    }
  }
  return pointer;
}

std::string pointer_to(const std::string& parent, std::size_t index) {
  return parent + "/" + std::to_string(index);
}

std::string Range::text() const {
  const bool has_low = std::isfinite(low), has_high = std::isfinite(high);
  if (has_low && has_high) {
    return std::string("in ") + (low_excluded ? "(" : "[") + format(low) + ", " + format(high) +
           "]";
  }
  if (has_low) return (low_excluded ? "> " : ">= ") + format(low);
  if (has_high) return "<= " + format(high);
  return "";
}

Json number_schema(const KeyInfo& key, const char* type) {
  Json schema{{"type", type}};
  const Range& range = key.range;
  if (std::isfinite(range.low)) {
    schema[range.low_excluded ? "exclusiveMinimum" : "minimum"] = range.low;
  }
  if (std::isfinite(range.high)) schema["maximum"] = range.high;
  return schema;
}

Json list_schema(Json items) { return {{"type", "array"}, {"items", std::move(items)}}; }

Json vector_schema(const KeyInfo& key) {
  Json schema = list_schema(number_schema(key));
  schema["minItems"] = 3;
  schema["maxItems"] = 3;
  return schema;
}

Json choice_schema(std::vector<Json> alternatives) { return {{"anyOf", std::move(alternatives)}}; }

Json key_schema(const KeyInfo& key) {
  Json schema = key.value_schema(key);
  schema["description"] = key.meaning + (key.unit.empty() ? "" : " [" + key.unit + "]");
  if (!key.required) schema["default"] = key.default_value;
  return schema;
}

Json object_schema(const std::vector<KeyInfo>& keys) {
  Json properties = Json::object(), required = Json::array();
  for (const KeyInfo& key : keys) {
    properties[key.name] = key_schema(key);
    if (key.required) required.push_back(key.name);
  }
  return {{"type", "object"},
          {"properties", std::move(properties)},
          {"required", std::move(required)},
          {"additionalProperties", false}};
}

std::string KeyInfo::expected() const {
  std::string text = "expected " + type;
  if (!range.text().empty()) text += " " + range.text();
  if (!unit.empty()) text += " in " + unit;
  return text;
}

namespace {

void report_mismatch(const Json& json, const std::string& pointer, const KeyInfo& info,
                     ParseContext& context) {
  std::string found = json.dump();
  if (found.size() > 40) found = found.substr(0, 37) + "...";
  context.problem(pointer, info.expected() + ", found " + found);
}

}  // namespace

std::string Codec<double>::type() { return "number"; }
Json Codec<double>::schema(const KeyInfo& key) { return number_schema(key); }
Json Codec<double>::write(double value) { return value; }
void Codec<double>::read(const Json& json, const std::string& pointer, const KeyInfo& info,
                         ParseContext& context, double& out) {
  if (!json.is_number() || !info.range.contains(json.get<double>())) {
    report_mismatch(json, pointer, info, context);
  } else {
    out = json.get<double>();
  }
}

std::string Codec<int>::type() { return "integer"; }
Json Codec<int>::schema(const KeyInfo& key) { return number_schema(key, "integer"); }
Json Codec<int>::write(int value) { return value; }
void Codec<int>::read(const Json& json, const std::string& pointer, const KeyInfo& info,
                      ParseContext& context, int& out) {
  const double value = json.is_number() ? json.get<double>() : 0.0;
  if (!json.is_number() || value != std::floor(value) || !info.range.contains(value) ||
      std::abs(value) > std::numeric_limits<int>::max()) {
    report_mismatch(json, pointer, info, context);
  } else {
    out = static_cast<int>(value);
  }
}

std::string Codec<bool>::type() { return "true or false"; }
Json Codec<bool>::schema(const KeyInfo&) { return {{"type", "boolean"}}; }
Json Codec<bool>::write(bool value) { return value; }
void Codec<bool>::read(const Json& json, const std::string& pointer, const KeyInfo& info,
                       ParseContext& context, bool& out) {
  if (!json.is_boolean()) {
    report_mismatch(json, pointer, info, context);
  } else {
    out = json.get<bool>();
  }
}

std::string Codec<std::string>::type() { return "text"; }
Json Codec<std::string>::schema(const KeyInfo&) { return {{"type", "string"}}; }
Json Codec<std::string>::write(const std::string& value) { return value; }
void Codec<std::string>::read(const Json& json, const std::string& pointer, const KeyInfo& info,
                              ParseContext& context, std::string& out) {
  if (!json.is_string()) {
    report_mismatch(json, pointer, info, context);
  } else {
    out = json.get<std::string>();
  }
}

std::string Codec<Eigen::Vector3d>::type() { return "list of 3 numbers"; }
Json Codec<Eigen::Vector3d>::schema(const KeyInfo& key) { return vector_schema(key); }
Json Codec<Eigen::Vector3d>::write(const Eigen::Vector3d& value) {
  return Json::array({value.x(), value.y(), value.z()});
}
void Codec<Eigen::Vector3d>::read(const Json& json, const std::string& pointer, const KeyInfo& info,
                                  ParseContext& context, Eigen::Vector3d& out) {
  const bool numbers = json.is_array() && json.size() == 3 &&
                       std::all_of(json.begin(), json.end(), [&](const Json& entry) {
                         return entry.is_number() && info.range.contains(entry.get<double>());
                       });
  if (!numbers) {
    report_mismatch(json, pointer, info, context);
  } else {
    for (int i = 0; i < 3; ++i) out[i] = json[i].get<double>();
  }
}

std::string Codec<ScenePath>::type() { return "path of a file"; }
Json Codec<ScenePath>::schema(const KeyInfo&) { return {{"type", "string"}}; }
Json Codec<ScenePath>::write(const ScenePath& value) { return value.absolute.string(); }
void Codec<ScenePath>::read(const Json& json, const std::string& pointer, const KeyInfo& info,
                            ParseContext& context, ScenePath& out) {
  if (!json.is_string()) {
    report_mismatch(json, pointer, info, context);
    return;
  }
  const auto path = std::filesystem::absolute(context.folder / json.get<std::string>());
  if (!std::filesystem::is_regular_file(path)) {
    context.problem(pointer, "there is no file '" + path.lexically_normal().string() + "'");
    return;
  }
  out.absolute = path.lexically_normal();
}

std::string Codec<MotionName>::type() { return "name of a motion"; }
Json Codec<MotionName>::schema(const KeyInfo&) { return {{"type", "string"}}; }
Json Codec<MotionName>::write(const MotionName& value) { return value.name; }
void Codec<MotionName>::read(const Json& json, const std::string& pointer, const KeyInfo& info,
                             ParseContext& context, MotionName& out) {
  if (!json.is_string()) {
    report_mismatch(json, pointer, info, context);
    return;
  }
  const auto name = json.get<std::string>();
  const auto& known = context.motions;
  if (!name.empty() && std::find(known.begin(), known.end(), name) == known.end()) {
    context.problem(pointer,
                    "there is no motion '" + name + "' in /motions; " + did_you_mean(name, known));
    return;
  }
  out.name = name;
}

void report_unknown_keys(const Json& object, const std::vector<KeyInfo>& keys,
                         const std::string& pointer, bool type_allowed, ParseContext& context) {
  std::vector<std::string> known;
  if (type_allowed) known.emplace_back("type");
  for (const KeyInfo& key : keys) known.push_back(key.name);
  for (const auto& [name, value] : object.items()) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    context.problem(pointer_to(pointer, name), "unknown key; " + did_you_mean(name, known));
  }
}

}  // namespace ringlet
