#pragma once

#include <functional>

#include "apps/study/variant.h"

namespace ringlet {

/// Where and how variants are run.
struct RunSettings {
  std::filesystem::path folder;  ///< of the study
  int repetitions = 1;
  int threads = 1;
  std::function<bool()> stop;  ///< becomes true when the study shall end
};

/// Runs a variant, or finds that it has run: every repetition that has ended, of exactly this scene
/// and by this version of ringlet, is kept. Returns its folders in order; fewer than were wanted
/// where the study was stopped. Throws Error if files cannot be written.
std::vector<std::filesystem::path> run_variant(const Variant& variant, const RunSettings& settings);

/// The folder of a variant.
std::filesystem::path variant_folder(const std::filesystem::path& study, const Variant& variant);

}  // namespace ringlet
