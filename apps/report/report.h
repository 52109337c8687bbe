#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/registry.h"

namespace ringlet {

/// One HTML file, complete in itself, of a run.
struct Report {
  std::string html;
  std::vector<std::string> notes;  ///< what was thinned, rounded or left out; the page says it, too
};

/// Puts what a run folder holds into a page. The positions, 6 bytes a vertex and frame before they
/// are packed, are thinned to the budget. Throws Error if the folder is none of a run or has no
/// frame that can be read.
Report make_report(const std::filesystem::path& folder, const std::string& page,
                   std::int64_t budget_bytes, const Registry& registry);

}  // namespace ringlet
