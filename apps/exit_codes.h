#pragma once

namespace ringlet {

/// What the program returns; its help explains them.
enum ExitCode : int {
  exit_ok = 0,
  exit_unexpected = 1,
  exit_bad_input = 2,
  exit_failed = 3,
  exit_interrupted = 130,
};

}  // namespace ringlet
