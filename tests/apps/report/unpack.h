#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/parameters.h"

namespace ringlet {

/// The inverse of pack_text(). Throws std::runtime_error where the text is none of its.
std::vector<std::uint8_t> unpack_text(const std::string& text);

/// What a report holds, read from its HTML.
struct ReportContent {
  Json record;
  std::vector<std::vector<double>> frames;          ///< m; x, y, z a vertex
  std::vector<std::vector<std::uint8_t>> contacts;  ///< one a vertex
};
ReportContent read_report(const std::string& html);

}  // namespace ringlet
