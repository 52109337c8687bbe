#pragma once

#include <string>
#include <vector>

#include "core/parameters.h"

namespace ringlet {

/// Figures of a benchmark: numbers and names, a list of them a row.
struct BenchTable {
  std::string title;
  std::vector<std::string> columns;
  std::vector<std::vector<Json>> rows = {};
};

/// The table in Markdown, numbers with three digits.
std::string as_markdown(const BenchTable& table);
/// {"title": ..., "rows": [{column: value, ...}, ...]}, numbers in full.
Json as_json(const BenchTable& table);

}  // namespace ringlet
