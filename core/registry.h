#pragma once

#include <functional>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "core/named.h"
#include "core/parameters.h"
#include "core/suggest.h"

namespace ringlet {

class StrandSource;
class StrandReader;
class RootSource;
class Pose;
class RestState;
class Motion;
class Energy;
class CouplingEnergy;
class Force;
class LinearSolver;
class Integrator;
class CollisionStage;
class ContactDetector;
class ContactEnergy;
class Collider;
class Observer;

// What kind of plugin an interface is, in words of the scene.
template <>
struct Kind<StrandSource> {
  static constexpr const char* name = "strand source";
};
template <>
struct Kind<StrandReader> {
  static constexpr const char* name = "strand reader";
};
template <>
struct Kind<RootSource> {
  static constexpr const char* name = "root source";
};
template <>
struct Kind<Pose> {
  static constexpr const char* name = "start pose";
};
template <>
struct Kind<RestState> {
  static constexpr const char* name = "rest state";
};
template <>
struct Kind<Motion> {
  static constexpr const char* name = "motion";
};
template <>
struct Kind<Energy> {
  static constexpr const char* name = "energy";
};
template <>
struct Kind<CouplingEnergy> {
  static constexpr const char* name = "coupling";
};
template <>
struct Kind<Force> {
  static constexpr const char* name = "force";
};
template <>
struct Kind<LinearSolver> {
  static constexpr const char* name = "linear solver";
};
template <>
struct Kind<Integrator> {
  static constexpr const char* name = "integrator";
};
template <>
struct Kind<CollisionStage> {
  static constexpr const char* name = "collision stage";
};
template <>
struct Kind<ContactDetector> {
  static constexpr const char* name = "contact detector";
};
template <>
struct Kind<ContactEnergy> {
  static constexpr const char* name = "contact energy";
};
template <>
struct Kind<Collider> {
  static constexpr const char* name = "collider";
};
template <>
struct Kind<Observer> {
  static constexpr const char* name = "writer";
};

/// A kind's name as a key: linear_solver.
std::string kind_key(std::string kind);

/// A plugin chosen in a scene, {"type": NAME, ...} or just NAME. Its parameters are already
/// checked, so that make() can only fail for reasons outside the scene.
template <class Interface>
class Choice {
 public:
  Choice() = default;
  /// A default, completed from the registry when the scene is read.
  Choice(const char* type) : type_(type), resolved_{{"type", type}} {}  // NOLINT(*-explicit-*)
  Choice(std::string type, Json resolved, std::function<std::unique_ptr<Interface>()> make)
      : type_(std::move(type)), resolved_(std::move(resolved)), make_(std::move(make)) {}

  const std::string& type() const { return type_; }
  /// With every default written out.
  const Json& resolved() const { return resolved_; }
  std::unique_ptr<Interface> make() const {
    auto made = naming<Interface>(type_, make_);
    made->set_name(type_);
    return made;
  }

 private:
  std::string type_;
  Json resolved_;
  std::function<std::unique_ptr<Interface>()> make_;
};

/// What a plugin says about itself.
struct Description {
  std::string text;      ///< one line
  std::string equation;  ///< the formula, if it has one
  std::string source;    ///< where the formula stands
};

/// The plugins of one kind, by name.
template <class Interface>
class Catalogue {
 public:
  struct Entry {
    std::string name;
    Description description;
    std::string library;  ///< file it was loaded from; empty: it is of the program
    std::vector<KeyInfo> keys;
    std::function<Choice<Interface>(const Json&, const std::string& pointer, ParseContext&)> read;
  };

  /// Registers a plugin whose parameter struct P declares itself by P::schema(). Throws Error if
  /// the name is taken.
  template <class P>
  void add(const std::string& name, Description description,
           std::function<std::unique_ptr<Interface>(const P&)> make) {
    if (find(name) != nullptr) {
      throw Error(std::string("there are two plugins of kind ") + Kind<Interface>::name +
                  " named '" + name + "'");
    }
    const Schema<P> schema = P::schema();
    entries_.push_back(
        {name, std::move(description), library_, schema.infos(),
         [name, schema, make](const Json& json, const std::string& pointer, ParseContext& context) {
           P parameters;
           schema.read(json, pointer, context, parameters, true);
           Json resolved{{"type", name}};
           resolved.update(schema.write(parameters));
           return Choice<Interface>(name, std::move(resolved),
                                    [make, parameters] { return make(parameters); });
         }});
  }

  const Entry* find(const std::string& name) const {
    for (const Entry& entry : entries_) {
      if (entry.name == name) return &entry;
    }
    return nullptr;
  }
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const Entry& entry : entries_) names.push_back(entry.name);
    return names;
  }
  const std::vector<Entry>& entries() const { return entries_; }
  /// That of all that is added from now on.
  void set_library(const std::string& file) { library_ = file; }

 private:
  std::vector<Entry> entries_;
  std::string library_;
};

/// All plugins a program knows. main owns the only one; modules add themselves to it by functions
/// called from a table that CMake writes.
class Registry {
 public:
  template <class Interface>
  Catalogue<Interface>& of() {
    return std::get<Catalogue<Interface>>(catalogues_);
  }
  template <class Interface>
  const Catalogue<Interface>& of() const {
    return std::get<Catalogue<Interface>>(catalogues_);
  }
  /// Calls add(*this), and marks what it adds as loaded from a library file.
  template <class Add>
  void add_library(const std::string& file, const Add& add) {
    set_library(file);
    add(*this);
    set_library("");
    libraries_.push_back(file);
  }
  const std::vector<std::string>& libraries() const { return libraries_; }
  /// visit(kind name, catalogue) for every kind.
  template <class Visit>
  void for_each_kind(const Visit& visit) const {
    std::apply([&](const auto&... catalogue) { (visit_kind(visit, catalogue), ...); }, catalogues_);
  }

 private:
  void set_library(const std::string& file) {
    std::apply([&](auto&... catalogue) { (catalogue.set_library(file), ...); }, catalogues_);
  }
  template <class Visit, class Interface>
  static void visit_kind(const Visit& visit, const Catalogue<Interface>& catalogue) {
    visit(Kind<Interface>::name, catalogue);
  }

  std::tuple<Catalogue<StrandSource>, Catalogue<StrandReader>, Catalogue<RootSource>,
             Catalogue<Pose>, Catalogue<RestState>, Catalogue<Motion>, Catalogue<Energy>,
             Catalogue<CouplingEnergy>, Catalogue<Force>, Catalogue<LinearSolver>,
             Catalogue<Integrator>, Catalogue<CollisionStage>, Catalogue<ContactDetector>,
             Catalogue<ContactEnergy>, Catalogue<Collider>, Catalogue<Observer>>
      catalogues_;
  std::vector<std::string> libraries_;
};

template <class Interface>
struct Codec<Choice<Interface>> {
  static std::string type() { return std::string(Kind<Interface>::name); }
  static Json schema(const KeyInfo&) { return {{"$ref", "#/$defs/" + kind_key(type())}}; }
  static void read(const Json& json, const std::string& pointer, const KeyInfo&,
                   ParseContext& context, Choice<Interface>& out) {
    const Json object = json.is_string() ? Json{{"type", json}} : json;
    if (!object.is_object() || !object.contains("type") || !object["type"].is_string()) {
      context.problem(pointer, "expected a " + type() + ": its name or {\"type\": NAME, ...}; " +
                                   did_you_mean("", context.registry.of<Interface>().names()));
      return;
    }
    const auto name = object["type"].template get<std::string>();
    const auto& catalogue = context.registry.of<Interface>();
    const auto* entry = catalogue.find(name);
    if (entry == nullptr) {
      context.problem(pointer_to(pointer, "type"), "there is no " + type() + " '" + name + "'; " +
                                                       did_you_mean(name, catalogue.names()));
      return;
    }
    out = entry->read(object, pointer, context);
  }
  static Json write(const Choice<Interface>& choice) { return choice.resolved(); }
  static void complete(const std::string& pointer, ParseContext& context,
                       Choice<Interface>& choice) {
    read(choice.resolved(), pointer, {}, context, choice);
  }
};

/// "none" stands for the absence of a plugin, as null does.
template <class Interface>
struct Codec<std::optional<Choice<Interface>>> {
  static std::string type() { return Codec<Choice<Interface>>::type() + ", or none"; }
  static Json schema(const KeyInfo& key) {
    return choice_schema(
        {Codec<Choice<Interface>>::schema(key), {{"const", "none"}}, {{"type", "null"}}});
  }
  static void read(const Json& json, const std::string& pointer, const KeyInfo& info,
                   ParseContext& context, std::optional<Choice<Interface>>& out) {
    if (json.is_null() || json == "none") {
      out.reset();
    } else {
      Codec<Choice<Interface>>::read(json, pointer, info, context, out.emplace());
    }
  }
  static Json write(const std::optional<Choice<Interface>>& choice) {
    return choice ? choice->resolved() : Json();
  }
  static void complete(const std::string& pointer, ParseContext& context,
                       std::optional<Choice<Interface>>& choice) {
    if (choice) Codec<Choice<Interface>>::complete(pointer, context, *choice);
  }
};

}  // namespace ringlet
