#include "core/scene.h"

#include <algorithm>

#include "core/load_plugin.h"
#include "core/metrics.h"

namespace ringlet {

template <>
struct Codec<NamedMotions> {
  static std::string type() { return "object of lists of motions"; }
  static Json schema(const KeyInfo& key) {
    return {{"type", "object"},
            {"additionalProperties", Codec<std::vector<Choice<Motion>>>::schema(key)}};
  }
  static void read(const Json& json, const std::string& pointer, const KeyInfo& info,
                   ParseContext& context, NamedMotions& out) {
    if (!json.is_object()) {
      context.problem(pointer, info.expected());
      return;
    }
    for (const auto& [name, parts] : json.items()) {
      Codec<std::vector<Choice<Motion>>>::read(parts, pointer_to(pointer, name), info, context,
                                               out[name]);
    }
  }
  static Json write(const NamedMotions& motions) {
    Json json = Json::object();
    for (const auto& [name, parts] : motions) {
      json[name] = Codec<std::vector<Choice<Motion>>>::write(parts);
    }
    return json;
  }
};

/// One source, or a list of them whose strands stand in one scene.
template <>
struct Codec<std::vector<Choice<StrandSource>>> {
  using Source = Codec<Choice<StrandSource>>;
  static std::string type() { return "strand source, or list of them"; }
  static Json schema(const KeyInfo& key) {
    Json list = list_schema(Source::schema(key));
    list["minItems"] = 1;
    return choice_schema({Source::schema(key), list});
  }
  static void read(const Json& json, const std::string& pointer, const KeyInfo& info,
                   ParseContext& context, std::vector<Choice<StrandSource>>& out) {
    if (!json.is_array()) {
      Source::read(json, pointer, info, context, out.emplace_back());
      return;
    }
    if (json.empty()) context.problem(pointer, "expected at least one strand source");
    for (std::size_t i = 0; i < json.size(); ++i) {
      Source::read(json[i], pointer_to(pointer, i), info, context, out.emplace_back());
    }
  }
  static Json write(const std::vector<Choice<StrandSource>>& sources) {
    Json json = Json::array();
    for (const auto& source : sources) json.push_back(Source::write(source));
    return json;
  }
};

template <>
struct Codec<UncheckedObject> {
  static std::string type() { return "object"; }
  static Json schema(const KeyInfo&) { return {{"type", "object"}}; }
  static void read(const Json& json, const std::string& pointer, const KeyInfo& info,
                   ParseContext& context, UncheckedObject& out) {
    if (json.is_object()) {
      out.json = json;
    } else {
      context.problem(pointer, info.expected());
    }
  }
  static Json write(const UncheckedObject& object) { return object.json; }
};

Schema<RunParameters> RunParameters::schema() {
  return Schema<RunParameters>()
      .key("steps", &RunParameters::steps, "", at_least(0), "number of time steps")
      .key("write", &RunParameters::write, "", any_number(), "writers of the run folder")
      .key("checkpoint_seconds", &RunParameters::checkpoint_seconds, "s", at_least(0),
           "from one checkpoint to the next, after which `ringlet run --resume` goes on, of the "
           "time "
           "that the run takes; 0: there are none");
}

Schema<Expectation> Expectation::schema() {
  return Schema<Expectation>()
      .required("step", &Expectation::step, "", at_least(1), "step after which to look")
      .required("quantity", &Expectation::quantity, "", any_number(), "a column of metrics.csv")
      .key("min", &Expectation::min, "", any_number(), "smallest value that is right")
      .key("max", &Expectation::max, "", any_number(), "largest value that is right")
      .check([](Expectation& expectation, const std::string& pointer, ParseContext& context) {
        if (!expectation.min && !expectation.max) {
          context.problem(pointer, "expected 'min', 'max' or both");
        }
      });
}

Schema<Scene> Scene::schema() {
  return Schema<Scene>()
      .key("$schema", &Scene::schema_address, "", any_number(),
           "where an editor finds the JSON Schema of scenes; ignored otherwise")
      .key("about", &Scene::about, "", any_number(), "what the scene shows, for its readers")
      .key("plugins", &Scene::plugins, "", any_number(),
           "plugin libraries to load: paths, or names of RINGLET_PLUGIN_PATH")
      .key("motions", &Scene::motions, "", any_number(),
           "named rigid motions, which colliders and pinned strands may follow")
      .required("strands", &Scene::strands, "", any_number(), "the strands in their rest shape")
      .key("material", &Scene::material, "", any_number(), "what the strands are made of")
      .key("rest", &Scene::rest, "", any_number(),
           "chooses another rest state than that of the strands' shape, as one with which they do "
           "not sag")
      .key("start", &Scene::start, "", any_number(),
           "deformations, applied in order, that lead from the rest shape to the starting shape")
      .key("energies", &Scene::energies, "", any_number(), "the terms of the elastic potential")
      .key("couplings", &Scene::couplings, "", any_number(),
           "terms of the potential between vertices of any strands: glue, springs")
      .key("forces", &Scene::forces, "", any_number(), "gravity, drag, damping")
      .key("collision", &Scene::collision, "", any_number(), "finds contacts and resists them")
      .key("solver", &Scene::solver, "", any_number(), "of the linear system of a Newton step")
      .key("integrator", &Scene::integrator, "", any_number(), "advances time")
      .key("run", &Scene::run, "", any_number(), "how long, and what is written")
      .key("expect", &Scene::expect, "", any_number(), "bounds that a run of the scene must meet")
      .key("render", &Scene::render, "", any_number(),
           "how pictures of a run look: see `ringlet describe render`");
}

namespace {

void check_expectations(const Scene& scene, ParseContext& context) {
  std::vector<std::string> energies, known;
  for (const auto& energy : scene.energies) energies.push_back(energy.type());
  for (const auto& coupling : scene.couplings) energies.push_back(coupling.type());
  for (const Metric& metric : list_metrics(energies)) known.push_back(metric.name);
  for (std::size_t i = 0; i < scene.expect.size(); ++i) {
    const Expectation& expectation = scene.expect[i];
    // A quantity that could not be read is empty, and its problem is already known.
    if (expectation.quantity.empty()) continue;
    if (std::find(known.begin(), known.end(), expectation.quantity) == known.end()) {
      context.problem(pointer_to(pointer_to("/expect", i), "quantity"),
                      "there is no quantity '" + expectation.quantity + "'; " +
                          did_you_mean(expectation.quantity, known));
    }
  }
}

}  // namespace

Scene read_scene(const Json& json, const Registry& registry, const std::filesystem::path& folder) {
  std::vector<Problem> problems;
  ParseContext context{registry, folder, {}, problems};
  if (json.is_object() && json.contains("motions") && json["motions"].is_object()) {
    for (const auto& [name, parts] : json["motions"].items()) context.motions.push_back(name);
  }
  Scene scene;
  Scene::schema().read(json, "", context, scene);
  for (std::string& plugin : scene.plugins) plugin = plugin_file(plugin, folder);
  check_expectations(scene, context);
  if (!problems.empty()) throw InvalidInput(std::move(problems));
  return scene;
}

}  // namespace ringlet
