#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"

namespace ringlet {

class Registry;

/// JSON that keeps the order of its keys, so that an echo reads like its declaration.
using Json = nlohmann::ordered_json;

/// Everything a parameter may need to be read, and where its problems go.
struct ParseContext {
  const Registry& registry;
  std::filesystem::path folder;      ///< relative paths of the scene are relative to it
  std::vector<std::string> motions;  ///< names of the scene's motions
  std::vector<Problem>& problems;

  void problem(const std::string& pointer, std::string message) {
    problems.push_back({pointer, std::move(message)});
  }
};

/// The pointer to a key below another pointer, escaped as RFC 6901 asks.
std::string pointer_to(const std::string& parent, const std::string& key);
std::string pointer_to(const std::string& parent, std::size_t index);

/// The numbers a key allows.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_excluded = false;

  bool contains(double value) const {
    return (low_excluded ? value > low : value >= low) && value <= high;
  }
  /// "> 0", ">= 2", "in [0, 1]", or "" where everything is allowed.
  std::string text() const;
};
inline Range any_number() { return {}; }
inline Range positive() { return {.low = 0, .low_excluded = true}; }
inline Range at_least(double low) { return {.low = low}; }
inline Range between(double low, double high) { return {.low = low, .high = high}; }

/// What a declaration says about a key, for reading and for telling.
struct KeyInfo {
  std::string name;
  std::string unit;  ///< SI; "" for a pure number or what is no number
  Range range;
  std::string meaning;
  std::string type;       ///< "number", "integer", ...
  bool required = false;  ///< it has no default
  Json default_value;
  std::function<Json(const KeyInfo&)> value_schema;  ///< that of Codec

  /// "expected a number > 0 in m", for error messages.
  std::string expected() const;
};

/// A path that must exist; relative ones are relative to the scene file.
struct ScenePath {
  std::filesystem::path absolute;
};

/// The name of one of the scene's motions; empty: no motion.
struct MotionName {
  std::string name;
};

/// Names of the values of an enumeration: specialise with `static constexpr std::pair<Enum,
/// const char*> names[]`.
template <class Enum>
struct EnumNames;

/// The JSON Schema (draft 2020-12) of a key's value, with meaning, unit and default.
Json key_schema(const KeyInfo& key);
/// That of an object which has these keys and no others.
Json object_schema(const std::vector<KeyInfo>& keys);
/// Those of some types of value; numbers within the range of the key.
Json number_schema(const KeyInfo& key, const char* type = "number");
Json vector_schema(const KeyInfo& key);
Json list_schema(Json items);
Json choice_schema(std::vector<Json> alternatives);

/// How a type of parameter is read from JSON, written back, named, and told as a JSON Schema.
/// read() reports what is wrong and leaves `out` as it was. complete() is called where the key is
/// absent.
template <class M>
struct Codec;

template <>
struct Codec<double> {
  static std::string type();
  static Json schema(const KeyInfo& key);
  static void read(const Json& json, const std::string& pointer, const KeyInfo& info,
                   ParseContext& context, double& out);
  static Json write(double value);
};

template <>
struct Codec<int> {
  static std::string type();
  static Json schema(const KeyInfo& key);
  static void read(const Json& json, const std::string& pointer, const KeyInfo& info,
                   ParseContext& context, int& out);
  static Json write(int value);
};

template <>
struct Codec<bool> {
  static std::string type();
  static Json schema(const KeyInfo& key);
  static void read(const Json& json, const std::string& pointer, const KeyInfo& info,
                   ParseContext& context, bool& out);
  static Json write(bool value);
};

template <>
struct Codec<std::string> {
  static std::string type();
  static Json schema(const KeyInfo& key);
  static void read(const Json& json, const std::string& pointer, const KeyInfo& info,
                   ParseContext& context, std::string& out);
  static Json write(const std::string& value);
};

template <>
struct Codec<Eigen::Vector3d> {
  static std::string type();
  static Json schema(const KeyInfo& key);
  static void read(const Json& json, const std::string& pointer, const KeyInfo& info,
                   ParseContext& context, Eigen::Vector3d& out);
  static Json write(const Eigen::Vector3d& value);
};

template <>
struct Codec<ScenePath> {
  static std::string type();
  static Json schema(const KeyInfo& key);
  static void read(const Json& json, const std::string& pointer, const KeyInfo& info,
                   ParseContext& context, ScenePath& out);
  static Json write(const ScenePath& value);
};

template <>
struct Codec<MotionName> {
  static std::string type();
  static Json schema(const KeyInfo& key);
  static void read(const Json& json, const std::string& pointer, const KeyInfo& info,
                   ParseContext& context, MotionName& out);
  static Json write(const MotionName& value);
};

template <class M>
struct Codec<std::optional<M>> {
  static std::string type() { return Codec<M>::type() + ", or null"; }
  static Json schema(const KeyInfo& key) {
    return choice_schema({Codec<M>::schema(key), {{"type", "null"}}});
  }
  static void read(const Json& json, const std::string& pointer, const KeyInfo& info,
                   ParseContext& context, std::optional<M>& out) {
    if (json.is_null()) {
      out.reset();
      return;
    }
    M value{};
    const std::size_t problems = context.problems.size();
    Codec<M>::read(json, pointer, info, context, value);
    if (context.problems.size() == problems) out = std::move(value);
  }
  static Json write(const std::optional<M>& value) {
    return value ? Codec<M>::write(*value) : Json();
  }
};

template <class M>
struct Codec<std::vector<M>> {
  static std::string type() { return "list of " + Codec<M>::type(); }
  static Json schema(const KeyInfo& key) { return list_schema(Codec<M>::schema(key)); }
  static void read(const Json& json, const std::string& pointer, const KeyInfo& info,
                   ParseContext& context, std::vector<M>& out) {
    if (!json.is_array()) {
      context.problem(pointer, info.expected());
      return;
    }
    std::vector<M> values(json.size());
    for (std::size_t i = 0; i < json.size(); ++i) {
      Codec<M>::read(json[i], pointer_to(pointer, i), info, context, values[i]);
    }
    out = std::move(values);
  }
  static Json write(const std::vector<M>& values) {
    Json json = Json::array();
    for (const M& value : values) json.push_back(Codec<M>::write(value));
    return json;
  }
  static void complete(const std::string& pointer, ParseContext& context, std::vector<M>& values) {
    if constexpr (requires { Codec<M>::complete(pointer, context, values[0]); }) {
      for (M& value : values) Codec<M>::complete(pointer, context, value);
    }
  }
};

template <class Enum>
requires std::is_enum_v<Enum>
struct Codec<Enum> {
  static std::string type() {
    std::string text = "one of";
    for (const auto& [value, name] : EnumNames<Enum>::names) text += " '" + std::string(name) + "'";
    return text;
  }
  static Json schema(const KeyInfo&) {
    Json names = Json::array();
    for (const auto& [value, name] : EnumNames<Enum>::names) names.push_back(name);
    return {{"enum", names}};
  }
  static void read(const Json& json, const std::string& pointer, const KeyInfo& info,
                   ParseContext& context, Enum& out) {
    for (const auto& [value, name] : EnumNames<Enum>::names) {
      if (json == name) {
        out = value;
        return;
      }
    }
    context.problem(pointer, info.expected());
  }
  static Json write(Enum wanted) {
    for (const auto& [value, name] : EnumNames<Enum>::names) {
      if (value == wanted) return name;
    }
    return {};
  }
};

/// Problems of an object whose keys are not all known; "type" is known to every plugin.
void report_unknown_keys(const Json& object, const std::vector<KeyInfo>& keys,
                         const std::string& pointer, bool type_allowed, ParseContext& context);

/// The one declaration of a parameter struct T: a line a key gives reading, checking, telling and
/// echoing. Defaults are the initialisers of T's members.
///
///     static Schema<Gravity> schema() {
///       return Schema<Gravity>().key("acceleration", &Gravity::acceleration, "m/s^2",
///                                    any_number(), "of everything that is free to fall");
///     }
template <class T>
class Schema {
 public:
  template <class M>
  Schema& key(const std::string& name, M T::*member, const std::string& unit, const Range& range,
              const std::string& meaning) {
    return add(name, member, unit, range, meaning, false);
  }
  /// A key that a scene must give.
  template <class M>
  Schema& required(const std::string& name, M T::*member, const std::string& unit,
                   const Range& range, const std::string& meaning) {
    return add(name, member, unit, range, meaning, true);
  }
  /// Takes over all keys of a member that is a parameter struct itself, with the defaults that they
  /// have here.
  template <class Part>
  Schema& include(Part T::*part) {
    const Schema<Part> inner = Part::schema();
    for (const auto& key : inner.keys_) {
      KeyInfo info = key.info;
      if (!info.required) info.default_value = key.write(T{}.*part);
      keys_.push_back({std::move(info),
                       [read = key.read, part](const Json* json, const std::string& pointer,
                                               ParseContext& context,
                                               T& out) { read(json, pointer, context, out.*part); },
                       [write = key.write, part](const T& value) { return write(value.*part); }});
    }
    for (const auto& check : inner.checks_) {
      checks_.push_back([check, part](T& out, const std::string& pointer, ParseContext& context) {
        check(out.*part, pointer, context);
      });
    }
    return *this;
  }
  /// What no single key can see. Runs after all keys were read; may also fill derived defaults.
  Schema& check(std::function<void(T&, const std::string& pointer, ParseContext&)> check) {
    checks_.push_back(std::move(check));
    return *this;
  }

  void read(const Json& object, const std::string& pointer, ParseContext& context, T& out,
            bool type_allowed = false) const {
    if (!object.is_object()) {
      context.problem(pointer, "expected an object {...}");
      return;
    }
    const std::size_t problems = context.problems.size();
    report_unknown_keys(object, infos(), pointer, type_allowed, context);
    for (const Key& key : keys_) {
      const auto found = object.find(key.info.name);
      const std::string key_pointer = pointer_to(pointer, key.info.name);
      if (found == object.end() && key.info.required) {
        context.problem(key_pointer, "missing; " + key.info.expected() + ": " + key.info.meaning);
      } else {
        key.read(found == object.end() ? nullptr : &*found, key_pointer, context, out);
      }
    }
    if (context.problems.size() > problems) return;
    for (const auto& check : checks_) check(out, pointer, context);
  }

  Json write(const T& value) const {
    Json object = Json::object();
    for (const Key& key : keys_) object[key.info.name] = key.write(value);
    return object;
  }

  std::vector<KeyInfo> infos() const {
    std::vector<KeyInfo> infos;
    for (const Key& key : keys_) infos.push_back(key.info);
    return infos;
  }

 private:
  template <class U>
  friend class Schema;

  struct Key {
    KeyInfo info;
    std::function<void(const Json*, const std::string&, ParseContext&, T&)> read;
    std::function<Json(const T&)> write;
  };

  template <class M>
  Schema& add(const std::string& name, M T::*member, const std::string& unit, const Range& range,
              const std::string& meaning, bool required) {
    KeyInfo info{name, unit, range, meaning, Codec<M>::type(), required, {}, Codec<M>::schema};
    if (!required) info.default_value = Codec<M>::write(T{}.*member);
    const auto read = [member, info](const Json* json, const std::string& pointer,
                                     ParseContext& context, T& out) {
      if (json != nullptr) {
        Codec<M>::read(*json, pointer, info, context, out.*member);
      } else if constexpr (requires { Codec<M>::complete(pointer, context, out.*member); }) {
        Codec<M>::complete(pointer, context, out.*member);
      }
    };
    keys_.push_back(
        {info, read, [member](const T& value) { return Codec<M>::write(value.*member); }});
    return *this;
  }

  std::vector<Key> keys_;
  std::vector<std::function<void(T&, const std::string&, ParseContext&)>> checks_;
};

/// For a plugin that has no parameters.
struct NoParameters {
  static Schema<NoParameters> schema() { return {}; }
};

/// A nested object with a schema of its own.
template <class M>
requires requires { M::schema(); }
struct Codec<M> {
  static std::string type() { return "object"; }
  static Json schema(const KeyInfo&) { return object_schema(M::schema().infos()); }
  static void read(const Json& json, const std::string& pointer, const KeyInfo&,
                   ParseContext& context, M& out) {
    M::schema().read(json, pointer, context, out);
  }
  static Json write(const M& value) { return M::schema().write(value); }
  static void complete(const std::string& pointer, ParseContext& context, M& out) {
    read(Json::object(), pointer, {}, context, out);
  }
};

}  // namespace ringlet
