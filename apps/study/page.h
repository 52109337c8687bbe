#pragma once

#include <string>

#include "core/parameters.h"

namespace ringlet {

/// One HTML file, complete in itself, that shows the results of a study (what results.json holds).
/// Throws Error if the program was built without its pages, and says how to get them.
std::string study_page(const Json& results);

/// The same in a page of one's own, with a mark <!--DATA-->. Throws Error if it has none.
std::string study_page(const Json& results, const std::string& page);

}  // namespace ringlet
