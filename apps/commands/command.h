#pragma once

#include <functional>

#include "apps/arguments.h"
#include "core/registry.h"

namespace ringlet {

/// A command of the program; help and parsing both come from this.
struct Command {
  std::string name;
  std::vector<std::string> operands;  ///< names for the help; [NAME] may be left out
  std::string summary;                ///< one line
  std::vector<Option> options;
  /// Returns an exit code. Throws Error for bad input, before anything is written.
  std::function<int(Registry&, const Arguments&)> run;
};

Command run_command();
Command check_command();
Command list_command();
Command describe_command();
Command new_command();
Command verify_command();
Command eval_command();
Command bench_command();
Command render_command();
Command report_command();
Command study_command();
Command convert_command();
Command validate_command();

}  // namespace ringlet
