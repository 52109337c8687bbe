#include "core/scene_schema.h"

#include <algorithm>

#include "core/scene.h"

namespace ringlet {
namespace {

/// {"type": NAME, ...}.
template <class Entry>
Json plugin_schema(const Entry& entry) {
  Json schema = object_schema(entry.keys);
  Json properties{{"type", {{"const", entry.name}}}};
  properties.update(schema["properties"]);
  schema["properties"] = std::move(properties);
  schema["required"].insert(schema["required"].begin(), "type");
  schema["description"] = entry.description.text;
  return schema;
}

template <class Entry>
bool can_be_a_name(const Entry& entry) {
  return std::none_of(entry.keys.begin(), entry.keys.end(),
                      [](const KeyInfo& key) { return key.required; });
}

template <class Interface>
Json kind_schema(const Catalogue<Interface>& catalogue) {
  if (catalogue.entries().empty()) return false;
  std::vector<Json> alternatives;
  for (const auto& entry : catalogue.entries()) {
    if (!can_be_a_name(entry)) continue;
    alternatives.push_back({{"const", entry.name}, {"description", entry.description.text}});
  }
  for (const auto& entry : catalogue.entries()) alternatives.push_back(plugin_schema(entry));
  return choice_schema(std::move(alternatives));
}

}  // namespace

Json scene_schema(const Registry& registry) {
  Json schema{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
              {"title", "A scene of ringlet"}};
  schema.update(object_schema(Scene::schema().infos()));
  Json& kinds = schema["$defs"] = Json::object();
  registry.for_each_kind([&](const std::string& kind, const auto& catalogue) {
    kinds[kind_key(kind)] = kind_schema(catalogue);
  });
  return schema;
}

std::string kind_key(std::string kind) {
  std::replace(kind.begin(), kind.end(), ' ', '_');
  return kind;
}

}  // namespace ringlet
