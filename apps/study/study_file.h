#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/registry.h"

namespace ringlet {

/// Changes of a scene: JSON pointer -> value.
using SceneChanges = std::map<std::string, Json>;

/// A key of the scene, or several, that take the same values one after the other.
struct StudyAxis {
  std::string name;
  std::string label;
  std::string unit;
  std::optional<std::string> pointer;
  std::vector<std::string> pointers;
  std::vector<Json> values;

  static Schema<StudyAxis> schema();
};

/// How the values of several axes make variants.
enum class Combine { grid, zip, one_at_a_time };

template <>
struct EnumNames<Combine> {
  static constexpr std::pair<Combine, const char*> names[] = {
      {Combine::grid, "grid"}, {Combine::zip, "zip"}, {Combine::one_at_a_time, "one_at_a_time"}};
};

/// A variant that is written out.
struct StudyVariant {
  std::string name;
  Json scene;  ///< null: that of the study
  SceneChanges set;

  static Schema<StudyVariant> schema();
};

/// A variant that is far more accurate than the others.
struct StudyReference {
  SceneChanges set;

  static Schema<StudyReference> schema();
};

/// STUDY.json.
struct StudyFile {
  std::string about;
  Json scene;  ///< a path relative to the study, or a scene; null: each variant has its own
  SceneChanges set;
  std::optional<double> duration;
  std::optional<double> compare_every;
  std::vector<StudyAxis> axes;
  Combine combine = Combine::grid;
  std::vector<StudyVariant> variants;
  int repetitions = 1;
  std::optional<StudyReference> reference;
  std::vector<std::string> errors;

  static Schema<StudyFile> schema();
};

/// Reads a study. Throws InvalidInput with every problem in it, Error if it is no JSON.
StudyFile read_study_file(const std::filesystem::path& path);

}  // namespace ringlet
