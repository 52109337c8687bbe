#pragma once

#include <optional>

#include "apps/bench/output.h"
#include "core/registry.h"

namespace ringlet {

struct BenchOptions {
  /// For each figure that is a time, s; 0 only tries whether everything runs.
  double seconds = 0.5;
  std::optional<int> strands = {};  ///< of the largest hairball, where the benchmark has a choice
  int threads = 1;                  ///< the most that are used, where the benchmark has a choice

  bool quick() const { return seconds == 0; }
  /// Of the largest hairball.
  int strands_or(int otherwise) const { return strands.value_or(quick() ? 16 : otherwise); }
};

/// One benchmark of `ringlet bench`.
struct Bench {
  const char* name;
  const char* summary;
  void (*run)(const Registry&, const BenchOptions&, BenchOutput&);
  bool has_strands = false;  ///< whether it heeds that option
  bool has_threads = false;
};

/// All of them, in the order in which they are run.
std::vector<Bench> all_benches();

void bench_elements(const Registry& registry, const BenchOptions& options, BenchOutput& output);
void bench_filters(const Registry& registry, const BenchOptions& options, BenchOutput& output);
void bench_step(const Registry& registry, const BenchOptions& options, BenchOutput& output);
void bench_strand(const Registry& registry, const BenchOptions& options, BenchOutput& output);
void bench_solvers(const Registry& registry, const BenchOptions& options, BenchOutput& output);
void bench_colliders(const Registry& registry, const BenchOptions& options, BenchOutput& output);
void bench_limits(const Registry& registry, const BenchOptions& options, BenchOutput& output);
void bench_tolerance(const Registry& registry, const BenchOptions& options, BenchOutput& output);

/// A scene of apps/scenes, which the program carries along.
Json bundled_scene(const std::string& name);

}  // namespace ringlet
