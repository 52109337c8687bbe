#pragma once

#include "apps/bench/table.h"
#include "core/registry.h"

namespace ringlet {

struct BenchOptions {
  /// For each figure that is a time, s; 0 only tries whether everything runs.
  double seconds = 0.5;

  bool quick() const { return seconds == 0; }
};

/// One benchmark of `ringlet bench`.
struct Bench {
  const char* name;
  const char* summary;
  std::vector<BenchTable> (*run)(const Registry&, const BenchOptions&);
};

/// All of them, in the order in which they are run.
std::vector<Bench> all_benches();

std::vector<BenchTable> bench_filters(const Registry& registry, const BenchOptions& options);
std::vector<BenchTable> bench_step(const Registry& registry, const BenchOptions& options);
std::vector<BenchTable> bench_strand(const Registry& registry, const BenchOptions& options);
std::vector<BenchTable> bench_solvers(const Registry& registry, const BenchOptions& options);

/// A scene of apps/scenes, which the program carries along.
Json bundled_scene(const std::string& name);

}  // namespace ringlet
