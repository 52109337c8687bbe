#include <spdlog/fmt/fmt.h>

#include <cstdio>

#include "apps/commands/command.h"
#include "apps/exit_codes.h"
#include "core/scene.h"
#include "core/scene_schema.h"
#include "plugins/render/render_parameters.h"

namespace ringlet {
namespace {

void print_key(const KeyInfo& key, int indent) {
  std::string type = key.type;
  if (!key.range.text().empty()) type += " " + key.range.text();
  if (!key.unit.empty()) type += ", " + key.unit;
  const std::string value = key.required ? "required" : "default " + key.default_value.dump();
  fmt::print("{:{}}{:<18} {}; {}\n", "", indent, key.name, type, value);
  fmt::print("{:{}}{:<18} {}\n", "", indent, "", key.meaning);
}

template <class Entry>
void print_entry(const std::string& kind, const Entry& entry) {
  fmt::print("{} ({})\n  {}\n", entry.name, kind, entry.description.text);
  if (!entry.description.equation.empty()) {
    fmt::print("  equation: {}\n", entry.description.equation);
  }
  if (!entry.description.source.empty()) fmt::print("  source: {}\n", entry.description.source);
  if (!entry.library.empty()) fmt::print("  loaded from: {}\n", entry.library);
  fmt::print("{}", entry.keys.empty() ? "  no keys\n" : "  keys:\n");
  for (const KeyInfo& key : entry.keys) print_key(key, 4);
}

void print_scene() {
  fmt::print("scene (the whole file)\n  keys:\n");
  for (const KeyInfo& key : Scene::schema().infos()) print_key(key, 4);
}

void print_render() {
  fmt::print("render (how `ringlet render` draws a run)\n  keys:\n");
  for (const KeyInfo& key : RenderParameters::schema().infos()) {
    print_key(key, 4);
    const bool is_camera = key.name == "camera";
    if (!is_camera && key.name != "light") continue;
    for (const KeyInfo& inner :
         (is_camera ? CameraParameters::schema().infos() : LightParameters::schema().infos())) {
      print_key(inner, 6);
    }
  }
}

/// With the keys of the entry "render", which core does not know.
Json whole_schema(const Registry& registry) {
  Json schema = scene_schema(registry);
  for (KeyInfo key : Scene::schema().infos()) {
    if (key.name != "render") continue;
    key.value_schema = Codec<std::optional<RenderParameters>>::schema;
    schema["properties"]["render"] = key_schema(key);
  }
  return schema;
}

int describe_named(const Registry& registry, const std::string& name) {
  std::vector<std::string> known{"scene", "render"};
  if (name == "scene") print_scene();
  if (name == "render") print_render();
  bool found = name == "scene" || name == "render";
  registry.for_each_kind([&](const std::string& kind, const auto& catalogue) {
    for (const auto& entry : catalogue.entries()) {
      known.push_back(entry.name);
      if (entry.name != name) continue;
      found = true;
      print_entry(kind, entry);
    }
  });
  if (!found) throw Error("nothing is named '" + name + "'; " + did_you_mean(name, known));
  return exit_ok;
}

int describe(const Registry& registry, const Arguments& arguments) {
  const auto name = arguments.operand(0);
  if (name.has_value() == arguments.has("--schema")) {
    throw Error("expected the name of what to describe, or --schema for the whole scene");
  }
  if (name) return describe_named(registry, *name);
  fmt::print("{}\n", whole_schema(registry).dump(2));
  return exit_ok;
}

}  // namespace

Command describe_command() {
  return {
      "describe",
      {"[NAME]"},
      "keys, units, defaults, equation and source of what `list` names, of `scene` or `render`",
      {{.name = "--schema",
        .meaning = "instead, a JSON Schema of the whole scene, for editors and other programs"}},
      describe};
}

}  // namespace ringlet
