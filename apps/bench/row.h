#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "apps/bench/timing.h"
#include "core/parameters.h"

namespace ringlet {

/// What a benchmark measured of one thing. All benchmarks give their figures in this shape; what
/// has no meaning is absent.
struct BenchRow {
  std::string name;  ///< what was measured
  Json parameters = Json::object();
  std::optional<Timing> time = {};
  Json stages = Json::object();           ///< of that time, s each
  std::optional<double> ratio = {};       ///< time of the baseline of the same run over this time
  std::optional<double> iterations = {};  ///< of the linear solver
  std::optional<double> contacts = {};
  std::optional<std::int64_t> bytes = {};  ///< the most memory in use meanwhile
  Json figures = Json::object();           ///< whatever has no key above, in SI units
};

/// {"name", "parameters", "seconds", "spread", "stages", "ratio", "iterations", "contacts",
/// "bytes", "figures"}, without the keys that are absent or empty.
Json as_json(const BenchRow& row);

}  // namespace ringlet
