#include <spdlog/fmt/fmt.h>

#include <cstdio>

#include "apps/commands/command.h"
#include "apps/element_cases.h"
#include "apps/exit_codes.h"
#include "core/scene.h"

namespace ringlet {
namespace {

int eval(const Registry& registry, const Arguments& arguments) {
  const Json input = load_json(*arguments.operand(0));
  fmt::print("{}\n", evaluate_cases(registry, input, arguments.value("--filter")).dump());
  return exit_ok;
}

}  // namespace

Command eval_command() {
  return {"eval",
          {"CASES.json"},
          "energies, gradients and Hessians of single elements at given positions, as JSON",
          {{.name = "--filter",
            .value = "NAME",
            .meaning = "adds `filtered`, the Hessian with that filter"}},
          eval};
}

}  // namespace ringlet
