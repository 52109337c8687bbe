#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ringlet {

/// What a program printed.
struct ProgramOutput {
  int exit_code;  ///< -1 if a signal ended it
  std::string output;
  std::string errors;
};

/// Runs a program, found as a shell would find it but without a shell, with a text as its standard
/// input, and waits for it. Nothing if there is no such program. Throws Error if it cannot be
/// started.
std::optional<ProgramOutput> run_program(const std::vector<std::string>& words,
                                         const std::string& input);

}  // namespace ringlet
