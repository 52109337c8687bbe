#include "apps/expectations.h"

#include <spdlog/fmt/fmt.h>

namespace ringlet {

bool ExpectationResult::met() const {
  return value && (!expectation.min || *value >= *expectation.min) &&
         (!expectation.max || *value <= *expectation.max);
}

std::vector<ExpectationResult> check_step(std::span<const Expectation> expectations, int step,
                                          std::span<const Metric> metrics,
                                          std::span<const double> row) {
  std::vector<ExpectationResult> results;
  for (const Expectation& expectation : expectations) {
    if (expectation.step != step) continue;
    ExpectationResult result{expectation, std::nullopt};
    for (std::size_t i = 0; i < metrics.size(); ++i) {
      if (metrics[i].name == expectation.quantity) result.value = row[i];
    }
    results.push_back(std::move(result));
  }
  return results;
}

std::string describe(const ExpectationResult& result) {
  const Expectation& expectation = result.expectation;
  std::string text = fmt::format("step {}: {} ", expectation.step, expectation.quantity);
  text +=
      result.value ? fmt::format("= {:.4g}, expected", *result.value) : "was not reached, expected";
  if (expectation.min) text += fmt::format(" >= {}", *expectation.min);
  if (expectation.min && expectation.max) text += " and";
  if (expectation.max) text += fmt::format(" <= {}", *expectation.max);
  return text;
}

}  // namespace ringlet
