#include "apps/study/variant.h"

#include <spdlog/fmt/fmt.h>

#include <cctype>
#include <cmath>
#include <set>

#include "apps/overrides.h"
#include "apps/study/combinations.h"
#include "core/integrator.h"
#include "core/load_plugin.h"

namespace ringlet {
namespace {

namespace fs = std::filesystem;

struct BaseScene {
  Json json;
  fs::path folder;
};

BaseScene load_base(const Json& scene, const fs::path& folder) {
  if (!scene.is_string()) return {scene, folder / "."};
  const fs::path path = folder / scene.get<std::string>();
  return {load_json(path), path.parent_path() / "."};
}

void apply(Json& scene, const SceneChanges& changes) {
  for (const auto& [pointer, value] : changes) set_entry(scene, pointer, value);
}

constexpr std::size_t longest_folder_name = 100;

/// Of what no file system minds.
std::string folder_name(const std::string& name) {
  std::string safe;
  for (const char c : name.substr(0, longest_folder_name)) {
    if (c == ' ') continue;
    const bool is_safe = std::isalnum(static_cast<unsigned char>(c)) != 0 ||
                         std::string("=,.+-_").find(c) != std::string::npos;
    safe += is_safe ? c : '_';
  }
  return safe.find_first_not_of('.') == std::string::npos ? "_" + safe : safe;
}

class Maker {
 public:
  Maker(const StudyFile& study, const fs::path& folder, Registry& registry)
      : study_(study), folder_(folder), registry_(registry) {}

  StudyVariants make() {
    StudyVariants all;
    if (!study_.scene.is_null()) base_ = load_base(study_.scene, folder_);
    for (const Combination& combination : combine(study_)) {
      all.variants.push_back(of_axes(combination));
    }
    for (const StudyVariant& given : study_.variants) all.variants.push_back(written_out(given));
    if (!study_.axes.empty()) add_as_it_stands(all);
    if (study_.reference) {
      all.reference = complete("reference", base_, study_.reference->set, "/reference/set");
    }
    check_names(all);
    name_folders(all);
    if (!problems_.empty()) throw InvalidInput(std::move(problems_));
    return all;
  }

 private:
  Variant of_axes(const Combination& combination) {
    SceneChanges changes;
    std::string name, place;
    std::map<std::string, std::string> values;
    for (const auto& [axis, value] : combination) {
      const StudyAxis& of = study_.axes[axis];
      const Json& entry = of.values[value];
      const bool is_labelled = entry.is_object() && entry.contains("label");
      for (const std::string& pointer : of.pointers) {
        changes[pointer] = is_labelled ? entry.value("value", Json()) : entry;
      }
      values[of.name] = in_words(entry);
      name += (name.empty() ? "" : ", ") + of.name + "=" + values[of.name];
      place = fmt::format("/axes/{}/values/{}", axis, value);
    }
    Variant variant = complete(name, base_, changes, place);
    variant.values = std::move(values);
    return variant;
  }

  Variant written_out(const StudyVariant& given) {
    const BaseScene base = given.scene.is_null() ? base_ : load_base(given.scene, folder_);
    return complete(given.name, base, given.set, "/variants/" + given.name);
  }

  /// place: in the study, for what is wrong with its time step.
  Variant complete(const std::string& name, const BaseScene& base, const SceneChanges& changes,
                   const std::string& place) {
    Variant variant;
    variant.name = name;
    try {
      Json json = base.json;
      apply(json, study_.set);
      apply(json, changes);
      const fs::path folder = fs::absolute(base.folder);
      load_plugins_of(json, folder, registry_);
      const Scene scene = read_scene(json, registry_, folder);
      variant.dt = scene.integrator.make()->time_step();
      variant.scene = resolved_[name] = scene.resolved();
      variant.scene["plugins"] = registry_.libraries();
      fit_time(variant, place);
    } catch (const Error& error) {
      variant.refusal = error.what();
    }
    return variant;
  }

  void fit_time(Variant& variant, const std::string& place) {
    if (study_.duration) {
      variant.scene["run"]["steps"] = whole(*study_.duration, variant.dt, place, "duration");
    }
    if (study_.reference) {
      variant.compare_every = whole(*study_.compare_every, variant.dt, place, "compare_every");
    }
  }
  int whole(double time, double dt, const std::string& place, const char* what) {
    const double count = time / dt;
    if (count < 0.5 || std::abs(count - std::round(count)) > 1e-6 * count) {
      problems_.push_back(
          {place, fmt::format("the time step {} s does not divide '{}', {} s", dt, what, time)});
    }
    return static_cast<int>(std::lround(count));
  }

  /// The scene as it stands is a variant, too.
  void add_as_it_stands(StudyVariants& all) {
    Variant plain = complete("as it stands", base_, {}, "/scene");
    if (!plain.refusal.empty()) return;
    for (const Variant& variant : all.variants) {
      if (!variant.refusal.empty() || resolved_[variant.name] != resolved_[plain.name]) continue;
      all.as_it_stands = variant.name;
      return;
    }
    all.as_it_stands = plain.name;
    all.variants.insert(all.variants.begin(), std::move(plain));
  }

  static void name_folders(StudyVariants& all) {
    std::set<std::string> taken;
    const auto name_folder = [&](Variant& variant) {
      const std::string plain = folder_name(variant.name);
      variant.folder = plain;
      for (int number = 2; !taken.insert(variant.folder).second; ++number) {
        variant.folder = plain + "_" + std::to_string(number);
      }
    };
    if (all.reference) name_folder(*all.reference);
    for (Variant& variant : all.variants) name_folder(variant);
  }

  void check_names(const StudyVariants& all) {
    std::set<std::string> names;
    for (const Variant& variant : all.variants) {
      if (names.insert(variant.name).second) continue;
      problems_.push_back({"/variants", "two variants are named '" + variant.name + "'"});
    }
  }

  const StudyFile& study_;
  fs::path folder_;
  Registry& registry_;
  BaseScene base_;
  std::map<std::string, Json> resolved_;  // the scene of each variant
  std::vector<Problem> problems_;
};

}  // namespace

StudyVariants make_variants(const StudyFile& study, const fs::path& folder, Registry& registry) {
  return Maker(study, folder, registry).make();
}

std::string in_words(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return fmt::format("{:.4g}", value.get<double>());
  if (value.is_object() && value.contains("label")) return in_words(value["label"]);
  if (value.is_object() && value.contains("type")) return in_words(value["type"]);
  return value.dump();
}

}  // namespace ringlet
