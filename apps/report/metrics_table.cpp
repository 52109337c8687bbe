#include "apps/report/metrics_table.h"

#include <cstdlib>
#include <fstream>
#include <limits>

namespace ringlet {
namespace {

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::size_t begin = 0;
  for (std::size_t comma = line.find(','); comma != std::string::npos;
       comma = line.find(',', begin)) {
    cells.push_back(line.substr(begin, comma - begin));
    begin = comma + 1;
  }
  cells.push_back(line.substr(begin));
  return cells;
}

double number_in(const std::string& cell) {
  return cell.empty() ? std::numeric_limits<double>::quiet_NaN()
                      : std::strtod(cell.c_str(), nullptr);
}

}  // namespace

MetricsTable read_metrics_table(const std::filesystem::path& path) {
  MetricsTable table;
  std::ifstream file(path);
  std::string line;
  // A line that the end of the file ends is not whole.
  while (std::getline(file, line) && !file.eof()) {
    const std::vector<std::string> cells = cells_of(line);
    if (table.names.empty()) {
      table.names = cells;
      table.columns.resize(cells.size());
    } else if (cells.size() == table.names.size()) {
      for (std::size_t i = 0; i < cells.size(); ++i) {
        table.columns[i].push_back(number_in(cells[i]));
      }
    }
  }
  return table;
}

}  // namespace ringlet
