#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <cstdio>

#include "apps/commands/chosen.h"
#include "apps/commands/command.h"
#include "apps/exit_codes.h"
#include "apps/validate/validation.h"
#include "core/json_file.h"

namespace ringlet {
namespace {

void print_head() {
  fmt::print(
      "| case | quantity | expected | measured | error | tolerance | order | |\n"
      "|---|---|---|---|---|---|---|---|\n");
}

void print_row(const ValidationRow& row) {
  std::string order = row.order ? fmt::format("{:.2f}", *row.order) : "";
  if (row.least_order) order += fmt::format(" (>= {})", *row.least_order);
  fmt::print("| {} | {} | {:.6g} | {:.6g} | {:.1e} | {:g} | {} | {} |\n", row.name, row.quantity,
             row.expected, row.measured, row.error(), row.tolerance, order,
             row.passes() ? "pass" : "FAIL");
  std::fflush(stdout);
}

Json as_json(const ValidationRow& row) {
  return {{"case", row.name},
          {"quantity", row.quantity},
          {"expected", row.expected},
          {"measured", row.measured},
          {"error", row.error()},
          {"tolerance", row.tolerance},
          {"order", row.order ? Json(*row.order) : Json()},
          {"passes", row.passes()}};
}

int validate(const Registry& registry, const Arguments& arguments) {
  const std::vector<ValidationCase> cases =
      chosen(all_validation_cases(), arguments.operand(0), "case");
  const ValidationOptions options{arguments.has("--quick")};
  Json rows = Json::array();
  bool all_pass = true;
  const auto add = [&](const ValidationRow& row) {
    print_row(row);
    rows.push_back(as_json(row));
    all_pass &= row.passes();
  };
  print_head();
  for (const ValidationCase& one : cases) {
    try {
      one.run(registry, options, add);
    } catch (const Error& error) {
      spdlog::error("{}: {}", one.name, error.what());
      all_pass = false;
    }
  }
  if (const auto path = arguments.value("--json")) write_json(*path, {{"rows", rows}});
  return all_pass ? exit_ok : exit_unexpected;
}

}  // namespace

Command validate_command() {
  std::string summary = "compares simulations with closed-form answers:";
  for (const ValidationCase& one : all_validation_cases()) {
    summary += fmt::format("\n        {:<17} {}", one.name, one.summary);
  }
  return {"validate",
          {"[CASE]"},
          summary,
          {{.name = "--quick", .meaning = "a part of it, in a second or two"},
           {.name = "--json", .value = "FILE", .meaning = "all rows as JSON"}},
          validate};
}

}  // namespace ringlet
