#include "apps/bench/output.h"

namespace ringlet {

void BenchOutput::start_table(const std::string& title, std::vector<Column> columns) {
  columns_ = std::move(columns);
  print_("\n" + table_head(title, columns_));
}

void BenchOutput::add(const BenchRow& row) {
  rows_.push_back(as_json(row));
  print_(table_row(columns_, rows_.back()));
}

}  // namespace ringlet
