#include "plugins/scene_colliders.h"

#include <spdlog/fmt/fmt.h>

#include "core/motion.h"
#include "core/read_choice.h"

namespace ringlet {
namespace {

Motions make_motions(const Json& scene, const Registry& registry) {
  Motions motions;
  if (!scene.contains("motions")) return motions;
  for (const auto& [name, parts] : scene["motions"].items()) {
    std::vector<std::unique_ptr<Motion>> made;
    for (const Json& part : parts) made.push_back(make_chosen<Motion>(registry, part));
    motions.add(name, std::move(made));
  }
  return motions;
}

PlacedCollider place(const Json& collider, const Motions& motions,
                     const std::vector<double>& times) {
  PlacedCollider placed{collider.at("type"), collider, {}};
  const std::string motion = collider.value("motion", "");
  for (const double time : times) placed.placements.push_back(motions.at(motion, time));
  return placed;
}

}  // namespace

std::string not_shown(const std::string& type, const std::string& reason) {
  return fmt::format("The collider '{}' is not shown: {}.", type, reason);
}

std::vector<PlacedCollider> place_colliders(const Json& scene, const Registry& registry,
                                            const std::vector<double>& times,
                                            std::vector<std::string>& notes) {
  std::vector<PlacedCollider> placed;
  const Json colliders = scene.value("/collision/colliders"_json_pointer, Json::array());
  if (colliders.empty()) return placed;
  try {
    const Motions motions = make_motions(scene, registry);
    for (const Json& collider : colliders) {
      try {
        placed.push_back(place(collider, motions, times));
      } catch (const std::exception& error) {
        notes.push_back(not_shown(collider.value("type", "?"), error.what()));
      }
    }
  } catch (const std::exception& error) {
    notes.push_back(fmt::format(
        "The colliders are not shown, since where they are is not known: {}.", error.what()));
  }
  return placed;
}

}  // namespace ringlet
