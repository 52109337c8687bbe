#pragma once

#include <filesystem>

#include "apps/study/variant.h"

namespace ringlet {

/// How a study is run.
struct StudyOptions {
  std::filesystem::path folder;
  int jobs = 1;     ///< variants at once
  int threads = 1;  ///< of each of them
  bool quiet = false;
};

/// What came of it.
struct StudyOutcome {
  Json results;  ///< as results.json has them
  bool interrupted = false;
};

/// Runs all variants of a study that have not run yet, the reference first, and writes results.json
/// and results.csv after each of them. Goes on with a study that was interrupted. Throws Error if
/// files cannot be written, or all variants are refused.
StudyOutcome run_study(const std::string& name, const StudyFile& study,
                       const StudyVariants& variants, const StudyOptions& options);

/// A table of the results, and what they recommend.
std::string tell_results(const Json& results);

}  // namespace ringlet
