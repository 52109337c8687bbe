#pragma once

#include <functional>
#include <string>
#include <vector>

#include "apps/bench/row.h"
#include "apps/bench/table.h"

namespace ringlet {

/// Where benchmarks put their rows: printed at once in a table, and all kept as JSON.
class BenchOutput {
 public:
  using Print = std::function<void(const std::string&)>;
  explicit BenchOutput(Print print) : print_(std::move(print)) {}

  /// Begins a table of the rows to come.
  void start_table(const std::string& title, std::vector<Column> columns);
  void add(const BenchRow& row);
  /// As as_json() gives them, an array.
  const Json& rows() const { return rows_; }

 private:
  Print print_;
  std::vector<Column> columns_;
  Json rows_ = Json::array();
};

}  // namespace ringlet
