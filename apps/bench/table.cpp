#include "apps/bench/table.h"

#include <spdlog/fmt/fmt.h>

#include <cmath>

namespace ringlet {
namespace {

std::string three_digits(double number) {
  const bool plain = number == 0 || (std::abs(number) >= 1e-3 && std::abs(number) < 1e6);
  if (!plain) return fmt::format("{:.2e}", number);
  const int digits =
      number == 0 ? 0 : 2 - static_cast<int>(std::floor(std::log10(std::abs(number))));
  return fmt::format("{:.{}f}", number, std::max(0, digits));
}

std::string cell(const Column& column, const Json& row) {
  const Json::json_pointer pointer(column.pointer);
  if (!row.contains(pointer)) return "";
  const Json& value = row[pointer];
  if (value.is_string()) return value.get<std::string>();
  const bool is_real = value.is_number() && (value.is_number_float() || column.unit != 1);
  return is_real ? three_digits(value.get<double>() / column.unit) : value.dump();
}

std::string line(const std::vector<std::string>& cells) {
  return fmt::format("| {} |\n", fmt::join(cells, " | "));
}

}  // namespace

std::string table_head(const std::string& title, const std::vector<Column>& columns) {
  std::vector<std::string> headings;
  for (const Column& column : columns) headings.push_back(column.heading);
  return title + "\n\n" + line(headings) + line(std::vector<std::string>(columns.size(), "---"));
}

std::string table_row(const std::vector<Column>& columns, const Json& row) {
  std::vector<std::string> cells;
  for (const Column& column : columns) cells.push_back(cell(column, row));
  return line(cells);
}

}  // namespace ringlet
