#include "apps/bench/bench.h"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <cstdio>

#include "apps/build_info.h"
#include "apps/commands/command.h"
#include "apps/exit_codes.h"
#include "apps/machine.h"
#include "core/atomic_file.h"

namespace ringlet {
namespace {

std::vector<Bench> chosen(const std::optional<std::string>& wanted) {
  std::vector<Bench> benches;
  std::vector<std::string> names;
  for (const Bench& bench : all_benches()) {
    names.push_back(bench.name);
    if (!wanted || *wanted == bench.name) benches.push_back(bench);
  }
  if (benches.empty()) {
    throw Error("there is no benchmark '" + *wanted + "'; " + did_you_mean(*wanted, names));
  }
  return benches;
}

int bench(const Registry& registry, const Arguments& arguments) {
  if (std::string(build_info::build_type) != "Release") {
    spdlog::warn("this is a {} build; only the times of a Release build mean something",
                 build_info::build_type);
  }
  BenchOptions options;
  if (arguments.has("--quick")) options.seconds = 0;
  Json tables = Json::array();
  for (const Bench& bench : chosen(arguments.operand(0))) {
    for (const BenchTable& table : bench.run(registry, options)) {
      fmt::print("{}\n", as_markdown(table));
      tables.push_back(as_json(table));
    }
  }
  if (const auto path = arguments.value("--json")) {
    AtomicFile file(*path);
    Json report = describe_machine();
    report["tables"] = tables;
    file.stream() << report.dump(2) << '\n';
    file.commit();
  }
  return exit_ok;
}

}  // namespace

Command bench_command() {
  std::string summary = "measures this build on this machine:";
  for (const Bench& bench : all_benches()) {
    summary += fmt::format("\n        {:<10} {}", bench.name, bench.summary);
  }
  return {"bench",
          {"[NAME]"},
          summary,
          {{.name = "--json", .value = "FILE", .meaning = "writes all figures as JSON, too"},
           {.name = "--quick", .meaning = "only tries whether everything runs"}},
          bench};
}

}  // namespace ringlet
