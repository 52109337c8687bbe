#pragma once

#include <string>

namespace ringlet {

// Pages that the program carries along: HTML files with a mark <!--DATA-->, see fill_page. CMake
// writes the definitions. Each throws Error if the program was built without its pages, and says
// how to get them.

/// The page of `ringlet report`.
std::string report_page_template();
/// The page of `ringlet study`.
std::string study_page_template();

}  // namespace ringlet
