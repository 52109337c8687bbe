#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/json_file.h"
#include "core/material_field.h"
#include "core/registry.h"

namespace ringlet {

/// How long a scene runs and what is written.
struct RunParameters {
  int steps = 300;
  std::vector<Choice<Observer>> write;
  double checkpoint_seconds = 10;

  static Schema<RunParameters> schema();
};

/// A bound on a quantity of the run at a step, which tests and users check.
struct Expectation {
  int step = 0;
  std::string quantity;
  std::optional<double> min, max;

  static Schema<Expectation> schema();
};

/// A motion of a scene: its name, and its parts.
using NamedMotions = std::map<std::string, std::vector<Choice<Motion>>>;

/// An object that other parts of the program read and check.
struct UncheckedObject {
  Json json = Json::object();
};

/// A scene, read and checked.
struct Scene {
  std::vector<std::string> plugins;
  NamedMotions motions;
  std::vector<Choice<StrandSource>> strands;
  MaterialField material;
  std::optional<Choice<RestState>> rest;
  std::vector<Choice<Pose>> start;
  std::vector<Choice<Energy>> energies{"stretch", "bending", "twist"};
  std::vector<Choice<CouplingEnergy>> couplings;
  std::vector<Choice<Force>> forces;
  std::optional<Choice<CollisionStage>> collision;
  Choice<LinearSolver> solver{"auto"};
  Choice<Integrator> integrator{"bdf1"};
  RunParameters run;
  std::vector<Expectation> expect;
  std::optional<UncheckedObject> render;
  std::string about;
  std::optional<std::string> schema_address;

  static Schema<Scene> schema();
  /// The effective scene, with every default written out.
  Json resolved() const { return schema().write(*this); }
};

/// Reads a scene. Throws InvalidInput with every problem in it. Relative paths in the scene are
/// relative to folder.
Scene read_scene(const Json& json, const Registry& registry, const std::filesystem::path& folder);

}  // namespace ringlet
