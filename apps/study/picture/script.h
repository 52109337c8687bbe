#pragma once

#include <string>

#include "core/parameters.h"

namespace ringlet {

/// What gnuplot is told to write the picture of a study to its standard output. Texts of the
/// results appear within strings alone.
std::string picture_script(const Json& results);

}  // namespace ringlet
