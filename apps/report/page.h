#pragma once

#include <string>

namespace ringlet {

/// The page into which a report is written, an HTML file with a mark <!--DATA-->. CMake writes the
/// definition. Throws Error if the program was built without the page, and says how to get it.
std::string page_template();

}  // namespace ringlet
