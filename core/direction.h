#pragma once

#include <Eigen/Core>
#include <string>

#include "core/parameters.h"

namespace ringlet {

/// A parameter that is a direction: any vector but zero in a scene, of unit length once read.
struct Direction {
  Eigen::Vector3d unit = Eigen::Vector3d::UnitY();
};

template <>
struct Codec<Direction> {
  static std::string type() { return "direction [x, y, z] other than zero"; }
  static Json schema(const KeyInfo& key) {
    Json schema = vector_schema(key);
    schema["not"] = {{"const", {0, 0, 0}}};
    return schema;
  }
  static void read(const Json& json, const std::string& pointer, const KeyInfo& info,
                   ParseContext& context, Direction& out) {
    Eigen::Vector3d vector = out.unit;
    Codec<Eigen::Vector3d>::read(json, pointer, info, context, vector);
    if (vector.stableNorm() > 0) {
      out.unit = vector.stableNormalized();
    } else {
      context.problem(pointer, info.expected() + ", found " + json.dump());
    }
  }
  static Json write(const Direction& direction) {
    return Codec<Eigen::Vector3d>::write(direction.unit);
  }
};

}  // namespace ringlet
