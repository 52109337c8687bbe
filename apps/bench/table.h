#pragma once

#include <string>
#include <vector>

#include "core/parameters.h"

namespace ringlet {

/// A column of a table over rows of JSON.
struct Column {
  std::string heading;
  std::string pointer;  ///< to its value in a row; a row without it leaves the cell empty
  double unit = 1;      ///< the table shows numbers in this unit, "ms" being 1e-3
};

/// In Markdown: the title and the heads of the columns.
std::string table_head(const std::string& title, const std::vector<Column>& columns);
/// In Markdown: one row; numbers that are not integers with three digits.
std::string table_row(const std::vector<Column>& columns, const Json& row);

}  // namespace ringlet
