#pragma once

#include <optional>

#include "apps/study/error_measures.h"
#include "apps/study/variant.h"

namespace ringlet {

/// What the run folders of a variant hold.
struct RunResults {
  std::string status, reason;   ///< as in results.json
  std::vector<double> seconds;  ///< of all steps, of each repetition that finished
  int steps = 0;
  double newton_iterations = 0, linear_iterations = 0;  ///< means a step
  int steps_not_converged = 0;
  double penetration = 0;      ///< the largest, m
  double largest_kinetic = 0;  ///< J
  std::int64_t peak_memory_bytes = 0;
  std::vector<int> vertex_counts;     ///< of each strand; empty: nothing is compared
  std::vector<ComparedState> states;  ///< at the times of the study, but for its beginning
};

/// Reads them. Throws Error if a file that must be there is not what it should be.
RunResults read_results(const Variant& variant, const std::vector<std::filesystem::path>& runs);

/// The entry of a variant in results.json. reference: null: nothing is compared.
Json describe_variant(const Variant& variant, RunResults results, const RunResults* reference,
                      const std::string& run);

}  // namespace ringlet
