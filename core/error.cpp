#include "core/error.h"

namespace ringlet {
namespace {

std::string describe(const std::vector<Problem>& problems) {
  std::string text =
      std::to_string(problems.size()) + (problems.size() == 1 ? " problem:" : " problems:");
  for (const Problem& problem : problems) {
    text += "\n  " + (problem.pointer.empty() ? "(whole file)" : problem.pointer) + ": " +
            problem.message;
  }
  return text;
}

}  // namespace

InvalidInput::InvalidInput(std::vector<Problem> problems)
    : Error(describe(problems)), problems_(std::move(problems)) {}

}  // namespace ringlet
