#include "apps/bench/table.h"

#include <spdlog/fmt/fmt.h>

#include <cmath>

namespace ringlet {
namespace {

std::string cell(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_null()) return "";
  if (!value.is_number_float()) return value.dump();
  const double number = value.get<double>();
  const bool plain = number == 0 || (std::abs(number) >= 1e-3 && std::abs(number) < 1e6);
  if (!plain) return fmt::format("{:.2e}", number);
  const int digits =
      number == 0 ? 0 : 2 - static_cast<int>(std::floor(std::log10(std::abs(number))));
  return fmt::format("{:.{}f}", number, std::max(0, digits));
}

std::string line(const std::vector<std::string>& cells) {
  return fmt::format("| {} |\n", fmt::join(cells, " | "));
}

}  // namespace

std::string as_markdown(const BenchTable& table) {
  std::string text = table.title + "\n\n" + line(table.columns);
  text += line(std::vector<std::string>(table.columns.size(), "---"));
  for (const std::vector<Json>& row : table.rows) {
    std::vector<std::string> cells;
    for (const Json& value : row) cells.push_back(cell(value));
    text += line(cells);
  }
  return text;
}

Json as_json(const BenchTable& table) {
  Json rows = Json::array();
  for (const std::vector<Json>& row : table.rows) {
    Json object = Json::object();
    for (std::size_t i = 0; i < row.size(); ++i) object[table.columns[i]] = row[i];
    rows.push_back(std::move(object));
  }
  return {{"title", table.title}, {"rows", rows}};
}

}  // namespace ringlet
