#include "apps/study/study_file.h"

#include <algorithm>
#include <cmath>

#include "apps/study/error_measures.h"
#include "core/scene.h"

namespace ringlet {

template <>
struct Codec<Json> {
  static std::string type() { return "any value"; }
  static Json schema(const KeyInfo&) { return Json::object(); }
  static void read(const Json& json, const std::string&, const KeyInfo&, ParseContext&, Json& out) {
    out = json;
  }
  static Json write(const Json& value) { return value; }
};

template <>
struct Codec<SceneChanges> {
  static std::string type() { return "object of JSON pointers and values"; }
  static Json schema(const KeyInfo&) { return {{"type", "object"}}; }
  static void read(const Json& json, const std::string& pointer, const KeyInfo& info,
                   ParseContext& context, SceneChanges& out) {
    if (!json.is_object()) {
      context.problem(pointer, info.expected());
      return;
    }
    for (const auto& [key, value] : json.items()) {
      if (!key.starts_with('/')) {
        context.problem(pointer_to(pointer, key), "a JSON pointer begins with '/'");
      }
      out[key] = value;
    }
  }
  static Json write(const SceneChanges& changes) { return Json(changes); }
};

Schema<StudyAxis> StudyAxis::schema() {
  return Schema<StudyAxis>()
      .required("name", &StudyAxis::name, "", any_number(), "short, for the names of variants")
      .key("label", &StudyAxis::label, "", any_number(), "in words; the name if absent")
      .key("unit", &StudyAxis::unit, "", any_number(), "of the values")
      .key("pointer", &StudyAxis::pointer, "", any_number(), "JSON pointer into the scene")
      .key("pointers", &StudyAxis::pointers, "", any_number(),
           "the same, for several keys that take each value together")
      .required("values", &StudyAxis::values, "", any_number(),
                "of the keys, one after the other; {\"label\": TEXT, \"value\": VALUE} names one")
      .check([](StudyAxis& axis, const std::string& place, ParseContext& context) {
        if (axis.pointer) axis.pointers.insert(axis.pointers.begin(), *axis.pointer);
        if (axis.pointers.empty()) context.problem(place, "expected 'pointer' or 'pointers'");
        if (axis.values.empty()) {
          context.problem(pointer_to(place, "values"), "expected at least one value");
        }
        if (axis.label.empty()) axis.label = axis.name;
      });
}

Schema<StudyVariant> StudyVariant::schema() {
  return Schema<StudyVariant>()
      .required("name", &StudyVariant::name, "", any_number(), "of the variant")
      .key("scene", &StudyVariant::scene, "", any_number(), "instead of the scene of the study")
      .key("set", &StudyVariant::set, "", any_number(), "changes of the scene");
}

Schema<StudyReference> StudyReference::schema() {
  return Schema<StudyReference>().key("set", &StudyReference::set, "", any_number(),
                                      "changes of the scene");
}

namespace {

bool divides(double part, double whole) {
  const double count = whole / part;
  return count > 0.5 && std::abs(count - std::round(count)) < 1e-6 * count;
}

void check_study(StudyFile& study, const std::string& pointer, ParseContext& context) {
  const auto problem = [&](const char* key, const std::string& message) {
    context.problem(pointer_to(pointer, key), message);
  };
  if (study.axes.empty() && study.variants.empty()) {
    problem("axes", "expected axes, variants or both");
  }
  const bool needs_scene =
      !study.axes.empty() || study.reference ||
      std::any_of(study.variants.begin(), study.variants.end(),
                  [](const StudyVariant& variant) { return variant.scene.is_null(); });
  if (needs_scene && study.scene.is_null()) problem("scene", "missing; expected a path or a scene");
  if (study.reference && (!study.duration || !study.compare_every)) {
    problem("reference", "needs 'duration' and 'compare_every'");
  }
  if (study.duration && study.compare_every && !divides(*study.compare_every, *study.duration)) {
    problem("compare_every", "does not divide 'duration'");
  }
  if (study.combine == Combine::zip) {
    for (std::size_t i = 1; i < study.axes.size(); ++i) {
      if (study.axes[i].values.size() == study.axes[0].values.size()) continue;
      problem("axes", "to be zipped, all need as many values as the first one");
      break;
    }
  }
  const std::vector<std::string> known = error_names();
  for (const std::string& name : study.errors) {
    if (std::find(known.begin(), known.end(), name) == known.end()) {
      problem("errors", "there is no error '" + name + "'; " + did_you_mean(name, known));
    }
  }
  if (study.errors.empty()) study.errors = known;
}

}  // namespace

Schema<StudyFile> StudyFile::schema() {
  return Schema<StudyFile>()
      .key("about", &StudyFile::about, "", any_number(), "what the study asks, for its readers")
      .key("scene", &StudyFile::scene, "", any_number(), "path relative to the study, or a scene")
      .key("set", &StudyFile::set, "", any_number(), "changes of the scene, for all variants")
      .key("duration", &StudyFile::duration, "s", positive(),
           "simulated by every variant; the steps of its scene if absent")
      .key("compare_every", &StudyFile::compare_every, "s", positive(),
           "between the times at which states are compared")
      .key("axes", &StudyFile::axes, "", any_number(), "what is varied")
      .key("combine", &StudyFile::combine, "", any_number(),
           "grid: every value with every other; zip: the first of all, then the second, ...; "
           "one_at_a_time: the others as the scene has them")
      .key("variants", &StudyFile::variants, "", any_number(), "more variants, written out")
      .key("repetitions", &StudyFile::repetitions, "", at_least(1),
           "runs of each variant; times are medians")
      .key("reference", &StudyFile::reference, "", any_number(),
           "the variant that errors are measured against; without it there are none")
      .key("errors", &StudyFile::errors, "", any_number(), "which to show, the first one in front")
      .check(check_study);
}

StudyFile read_study_file(const std::filesystem::path& path) {
  const Json json = load_json(path);
  const Registry registry;
  std::vector<Problem> problems;
  ParseContext context{registry, path.parent_path(), {}, problems};
  StudyFile study;
  StudyFile::schema().read(json, "", context, study);
  if (!problems.empty()) throw InvalidInput(std::move(problems));
  return study;
}

}  // namespace ringlet
