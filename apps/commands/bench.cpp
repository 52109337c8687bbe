#include "apps/bench/bench.h"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cstdio>

#include "apps/build_info.h"
#include "apps/commands/chosen.h"
#include "apps/commands/command.h"
#include "apps/exit_codes.h"
#include "apps/machine.h"
#include "core/atomic_file.h"

namespace ringlet {
namespace {

/// Throws Error for an option that none of the benchmarks heeds.
BenchOptions read_options(const Arguments& arguments, const std::vector<Bench>& benches) {
  const auto heeds = [&](const char* option, bool Bench::*has) {
    if (!arguments.has(option)) return;
    if (std::any_of(benches.begin(), benches.end(), [&](const Bench& b) { return b.*has; })) return;
    std::vector<std::string> names;
    for (const Bench& bench : all_benches()) {
      if (bench.*has) names.push_back(bench.name);
    }
    throw Error(fmt::format("'{}' has no option {}; these have: {}", benches.front().name, option,
                            fmt::join(names, ", ")));
  };
  heeds("--strands", &Bench::has_strands);
  heeds("--threads", &Bench::has_threads);
  BenchOptions options;
  if (arguments.has("--quick")) options.seconds = 0;
  options.strands = arguments.integer("--strands", 1);
  options.threads =
      arguments.integer("--threads", 1).value_or(tbb::this_task_arena::max_concurrency());
  return options;
}

int bench(const Registry& registry, const Arguments& arguments) {
  if (std::string(build_info::build_type) != "Release") {
    spdlog::warn("this is a {} build; only the times of a Release build mean something",
                 build_info::build_type);
  }
  const std::vector<Bench> benches = chosen(all_benches(), arguments.operand(0), "benchmark");
  const BenchOptions options = read_options(arguments, benches);
  BenchOutput output([](const std::string& text) {
    fmt::print("{}", text);
    std::fflush(stdout);
  });
  for (const Bench& bench : benches) bench.run(registry, options, output);
  if (const auto path = arguments.value("--json")) {
    AtomicFile file(*path);
    Json report = describe_machine();
    report["rows"] = output.rows();
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
           {.name = "--strands",
            .value = "N",
            .meaning = "wisps of the largest hairball; of benchmarks that have one"},
           {.name = "--threads",
            .value = "N",
            .meaning = "the most; all cores if absent; of benchmarks that say how many they use"},
           {.name = "--quick", .meaning = "only tries whether everything runs"}},
          bench};
}

}  // namespace ringlet
